// The keyholes between those of keyhole_slow_test.cpp: maps bring the light that is known.
#include "support/keyhole_truth.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// At its default number of paths: 99% of the ratio lies within 2% of one.
TEST(KeyholeNightly, maps_bring_the_known_light_of_one_path_in_a_hundred_million_and_fewer) {
    for (const std::size_t k : {2, 3}) {
        const Keyhole& keyhole = kKeyholes.at(k);
        const Scene scene = procedural(std::string(keyhole.name), 64);
        const Estimate light = Estimate::over(4, [&](int i) {
            RenderSettings settings;
            settings.seed = static_cast<std::uint64_t>(i);
            return luminance(render_mean(scene, settings, 16).mean());
        });
        EXPECT_LT(worst_ratio(light, {keyhole_truth(keyhole).luminance, 0}), 0.02)
            << keyhole.name << " " << light.mean << " +- " << light.error;
    }
}

}  // namespace
}  // namespace sunfleck::engine
