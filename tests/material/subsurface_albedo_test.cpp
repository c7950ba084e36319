// Light out of a cloudy half-space, against numbers from pbrt-v4's formulas by finer quadrature.
#include "material/subsurface_albedo.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// The moments of Fresnel's reflectance are fits in pbrt-v4, and rings end earlier there.
TEST(SubsurfaceAlbedo, is_that_of_pbrt) {
    const SubsurfaceAlbedo water(1.33F, 0);
    const SubsurfaceAlbedo glass(1.5F, 0);
    struct Row {
        float single;
        float water;
        float glass;
    };
    for (const Row& row :
         {Row{0.3F, 0.0307F, 0.0233F}, Row{0.8F, 0.1860F, 0.1437F}, Row{0.95F, 0.4153F, 0.3394F},
          Row{0.99F, 0.6734F, 0.5981F}, Row{0.999F, 0.8988F, 0.8561F}}) {
        EXPECT_NEAR(water(row.single), row.water, 0.02F * row.water + 0.003F) << row.single;
        EXPECT_NEAR(glass(row.single), row.glass, 0.02F * row.glass + 0.003F) << row.single;
    }
}

TEST(SubsurfaceAlbedo, rises_from_nothing_to_nearly_all) {
    const SubsurfaceAlbedo whole(1.33F, 0.5F);
    EXPECT_EQ(whole(0), 0);
    float before = 0;
    for (float single = 0.01F; single < 1; single += 0.01F) {
        EXPECT_GE(whole(single), before) << single;
        before = whole(single);
    }
    EXPECT_LE(whole(1), 1);
    EXPECT_GT(whole(1), 0.95);
}

/// What scatters straight on needs more scatterings to come back.
TEST(SubsurfaceAlbedo, is_less_where_light_goes_forwards) {
    EXPECT_LT(SubsurfaceAlbedo(1.33F, 0.8F)(0.9F), SubsurfaceAlbedo(1.33F, 0)(0.9F));
}

}  // namespace
}  // namespace sunfleck::engine
