// The AOV `samples`: each photon that a visible point accepts is a deposit.
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(Samples, tell_how_many_photons_a_pixel_took) {
    const Scene scene = procedural("cornell", 12);
    RenderSettings settings;
    settings.photon.paths_per_pass = 500;
    settings.transport.indirect = IndirectLight::photons;
    settings.aovs[static_cast<std::size_t>(Aov::samples)] = true;
    const PassResult pass = render_pass(scene, settings, 0, learn_epoch(scene, settings, 0));
    double taken = 0;
    for (std::size_t i = 0; i < pass.image.pixels(); ++i)
        taken += pass.image.value(Aov::samples, i, 0).to_double();
    EXPECT_EQ(taken, static_cast<double>(pass.statistics[Count::deposits]));
    EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace sunfleck::engine
