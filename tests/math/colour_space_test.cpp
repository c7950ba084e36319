// Colour spaces against published matrices.
#include "math/colour_space.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

void expect_near(const Triple& found, const Triple& expected, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.at(i), expected.at(i), tolerance) << i;
}

TEST(ColourSpace, has_the_names_of_pbrt) {
    EXPECT_EQ(colour_space("ACES2065-1"), ColourSpace::aces2065_1);
    EXPECT_EQ(colour_space("rec2020"), ColourSpace::rec2020);
    EXPECT_EQ(colour_space("dci-p3"), ColourSpace::dci_p3);
    EXPECT_FALSE(colour_space("adobe"));
}

/// ITU-R BT.2087 for BT.2020 to BT.709; Display P3 to sRGB as CSS Color 4 prints it; ACES AP0 to
/// linear sRGB (Bradford) as the ACES project prints it.
TEST(ColourSpace, matrices_are_the_published_ones) {
    expect_near(srgb_of_light(ColourSpace::rec2020, {1, 0, 0}), {1.6605, -0.1246, -0.0182}, 2e-3);
    expect_near(srgb_of_light(ColourSpace::rec2020, {0, 1, 0}), {-0.5876, 1.1329, -0.1006}, 2e-3);
    expect_near(srgb_of_light(ColourSpace::dci_p3, {1, 0, 0}), {1.2249, -0.0421, -0.0196}, 2e-3);
    expect_near(srgb_of_surface(ColourSpace::aces2065_1, {1, 0, 0}), {2.5217, -0.2765, -0.0154},
                1e-2);
    expect_near(srgb_of_surface(ColourSpace::aces2065_1, {0, 1, 0}), {-1.1341, 1.3727, -0.1530},
                1e-2);
}

TEST(ColourSpace, whites_of_surfaces_are_white_and_of_lights_their_own) {
    for (const auto space :
         {ColourSpace::srgb, ColourSpace::dci_p3, ColourSpace::rec2020, ColourSpace::aces2065_1})
        expect_near(srgb_of_surface(space, {0.5, 0.5, 0.5}), {0.5, 0.5, 0.5}, 1e-6);
    const Triple warm = srgb_of_light(ColourSpace::aces2065_1, {1, 1, 1});
    EXPECT_GT(warm[0], warm[2] + 0.05);
    EXPECT_NEAR(0.2126 * warm[0] + 0.7152 * warm[1] + 0.0722 * warm[2], 1, 1e-3);
}

}  // namespace
}  // namespace sunfleck::engine
