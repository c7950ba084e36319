// Stands in for other kinds of processors, as far as this one can.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace sunfleck::engine::testing_support {

/// The parameter is a target of Highway; 0: what the processor has.
class OnProcessor : public ::testing::TestWithParam<std::int64_t> {
protected:
    void SetUp() override {
        choose(0);
        const std::int64_t supported = hwy::SupportedTargets();
        if (GetParam() != 0 && (supported & GetParam()) == 0) GTEST_SKIP();
        choose(GetParam());
    }
    void TearDown() override { choose(0); }

private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

/// Those that code is compiled for.
inline auto processors() {
    return ::testing::Values(0, HWY_SSSE3, HWY_AVX2);
}

}  // namespace sunfleck::engine::testing_support
