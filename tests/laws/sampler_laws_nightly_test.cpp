// The main law of samplers again, with intervals ten times narrower.
//
// Seed 7. The 99% intervals must lie within `slow_band` of the truth: 0.1% for each kind of
// sampler; wider where a space is dear to trace or chains hardly move. They are less than half of
// that wide, so that chance alone seldom leads out of the band.
#include "laws/sampler_laws.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::laws {
namespace {

class SamplerLawsInFull : public testing::TestWithParam<SamplerExample> {};

TEST_P(SamplerLawsInFull, estimates_are_unbiased) {
    const SamplerExample& example = GetParam();
    expect_unbiased(example, 7, example.passes.slow, 0.99, example.slow_band);
}

INSTANTIATE_TEST_SUITE_P(All, SamplerLawsInFull, testing::ValuesIn(sampler_examples()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine::laws
