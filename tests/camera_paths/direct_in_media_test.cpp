// The share of photons in the light that comes straight from lights to media.
#include "camera_paths/direct_in_media.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(DirectInMedia, is_brought_by_light_samples_where_all_of_a_ray_is_lit) {
    EXPECT_EQ(share_of_photons(1, 1e6F, 0.1F), 0);
    EXPECT_EQ(share_of_photons(0.2F, 0, 0.1F), 0);  // no photons
}

TEST(DirectInMedia, is_brought_by_photons_where_hardly_any_sample_is_lit) {
    EXPECT_GT(share_of_photons(0, 100, 0.05F), 0.99F);
    EXPECT_GT(share_of_photons(0.001F, 100, 0.05F), 0.99F);
}

TEST(DirectInMedia, is_brought_by_more_photons_the_more_there_are) {
    float before = 0;
    for (const float photons : {0.01F, 0.1F, 1.0F, 10.0F, 100.0F}) {
        const float share = share_of_photons(0.3F, photons, 0.05F);
        EXPECT_GT(share, before);
        EXPECT_LT(share, 1);
        before = share;
    }
    // Many photons in a cylinder of the width of a sample are as good as a light sample.
    EXPECT_NEAR(share_of_photons(0.3F, 1e6F, 0), 0.5F, 1e-3F);
}

}  // namespace
}  // namespace sunfleck::engine
