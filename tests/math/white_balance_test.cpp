// White balance: daylights, and what they become.
#include "math/white_balance.h"

#include "math/spectrum.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Tabulated chromaticities of CIE illuminants (CIE 15:2004, table T.3) at the temperatures of
/// their definition.
TEST(WhiteBalance, daylights_have_the_known_chromaticities) {
    struct Known {
        double kelvin;
        Chromaticity chromaticity;
    };
    for (const Known& known : {Known{5000, {0.3457, 0.3585}}, Known{5500, {0.3324, 0.3474}},
                               Known{6500, {0.3127, 0.3290}}, Known{7500, {0.2990, 0.3149}}}) {
        const Chromaticity c = daylight(known.kelvin);
        EXPECT_NEAR(c.x, known.chromaticity.x, 2e-4) << known.kelvin;
        EXPECT_NEAR(c.y, known.chromaticity.y, 2e-4) << known.kelvin;
    }
}

TEST(WhiteBalance, below_4000_kelvin_daylight_is_a_blackbody) {
    const Chromaticity c = daylight(2856);  // illuminant A
    EXPECT_NEAR(c.x, 0.4476, 3e-4);
    EXPECT_NEAR(c.y, 0.4075, 3e-4);
}

Vec3d balanced(const Spectrum& light, double kelvin) {
    const Vec3 rgb = light.to_rgb();
    Vec3d result(0);
    const auto rows = white_balance(kelvin);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[static_cast<int>(i)] +=
                rows[i][j] * static_cast<double>(rgb[static_cast<int>(j)]);
    return result;
}

TEST(WhiteBalance, its_illuminant_becomes_white) {
    for (const auto& [name, kelvin] : {std::pair("stdillum-D50", 5000.0), {"stdillum-A", 2856.0}}) {
        const Spectrum light = *named_spectrum(name);
        const Vec3d rgb = balanced(light.scaled(1 / light.luminance()), kelvin);
        EXPECT_NEAR(rgb.x, 1, 0.003) << name;
        EXPECT_NEAR(rgb.y, 1, 0.003) << name;
        EXPECT_NEAR(rgb.z, 1, 0.006) << name;
    }
    const Vec3d white = balanced(Spectrum::d65(), 6500);  // 6504 K by today's constants
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1, 0.001);
    EXPECT_GT(balanced(Spectrum::d65(), 4000).z, 1.3) << "daylight is blue for indoor film";
}

}  // namespace
}  // namespace sunfleck::engine
