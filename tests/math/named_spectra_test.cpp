// Named spectra against printed chromaticities, refractive indices and reflectances.
#include "math/colour.h"
#include "math/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

struct Chromaticity {
    const char* name;
    double x;
    double y;
};

// CIE 15:2004, tables T.3 and T.8; D60 of ACES: SMPTE ST 2065-1.
constexpr std::array<Chromaticity, 16> kIlluminants{{
    {"stdillum-A", 0.44757, 0.40745},
    {"stdillum-D50", 0.34567, 0.35851},
    {"stdillum-D65", 0.31272, 0.32903},
    {"illum-acesD60", 0.32168, 0.33767},
    {"stdillum-F1", 0.3131, 0.3371},
    {"stdillum-F2", 0.3721, 0.3751},
    {"stdillum-F3", 0.4091, 0.3941},
    {"stdillum-F4", 0.4402, 0.4031},
    {"stdillum-F5", 0.3138, 0.3452},
    {"stdillum-F6", 0.3779, 0.3882},
    {"stdillum-F7", 0.3129, 0.3292},
    {"stdillum-F8", 0.3458, 0.3586},
    {"stdillum-F9", 0.3741, 0.3727},
    {"stdillum-F10", 0.3458, 0.3588},
    {"stdillum-F11", 0.3805, 0.3769},
    {"stdillum-F12", 0.4370, 0.4042},
}};

TEST(NamedSpectra, illuminants_have_their_chromaticity_and_luminance_one) {
    for (const auto& [name, x, y] : kIlluminants) {
        const auto curve = named_spectrum(name);
        ASSERT_TRUE(curve) << name;
        EXPECT_NEAR(curve->luminance(), 1, 1e-5) << name;
        const Vec3 rgb = curve->to_rgb();
        const Triple xyz = xyz_of_rgb({rgb.x, rgb.y, rgb.z});
        const double sum = xyz[0] + xyz[1] + xyz[2];
        EXPECT_NEAR(xyz[0] / sum, x, 4e-4) << name;
        EXPECT_NEAR(xyz[1] / sum, y, 4e-4) << name;
    }
}

// Schott's data sheets: refractive index at the helium line d and Abbe number.
TEST(NamedSpectra, glasses_have_their_index_and_dispersion) {
    struct Glass {
        const char* name;
        double index;
        double abbe;
    };
    for (const auto& [name, index, abbe] :
         {Glass{"glass-BK7", 1.51680, 64.17}, Glass{"glass-BAF10", 1.67003, 47.11},
          Glass{"glass-FK51A", 1.48656, 84.47}, Glass{"glass-LASF9", 1.85025, 32.17},
          Glass{"glass-F5", 1.67271, 32.21}, Glass{"glass-F10", 1.72825, 28.41},
          Glass{"glass-F11", 1.78472, 25.76}}) {
        const auto curve = named_spectrum(name);
        ASSERT_TRUE(curve) << name;
        EXPECT_NEAR((*curve)(587.5618F), index, 3e-4) << name;
        const double dispersion = double{(*curve)(486.1327F)} - double{(*curve)(656.2725F)};
        EXPECT_NEAR((index - 1) / dispersion, abbe, 0.02 * abbe) << name;
        EXPECT_GT((*curve)(360), (*curve)(400));
        EXPECT_FALSE(curve->is_constant());
    }
}

double reflectance(const std::string& metal, float nm) {
    const double n{(*named_spectrum("metal-" + metal + "-eta"))(nm)};
    const double k{(*named_spectrum("metal-" + metal + "-k"))(nm)};
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

// Normal incidence at 550 nm and 650 nm; silver, aluminium, gold, copper: CRC Handbook of Chemistry
// and Physics, optical properties of metals, to within the spread between authors.
TEST(NamedSpectra, metals_reflect_as_measured) {
    EXPECT_NEAR(reflectance("Ag", 550), 0.97, 0.015);
    EXPECT_NEAR(reflectance("Al", 550), 0.916, 0.01);
    EXPECT_NEAR(reflectance("Au", 550), 0.82, 0.05);
    EXPECT_NEAR(reflectance("Au", 650), 0.955, 0.02);
    EXPECT_NEAR(reflectance("Cu", 550), 0.60, 0.05);
    EXPECT_NEAR(reflectance("Cu", 650), 0.94, 0.03);
    EXPECT_NEAR(reflectance("CuZn", 550), 0.79, 0.03);
    EXPECT_NEAR(reflectance("MgO", 550), 0.0727, 1e-3);
    EXPECT_NEAR(reflectance("TiO2", 550), 0.243, 0.01);
}

TEST(NamedSpectra, values_between_points_are_linear) {
    // Two points of the table, 539.061 and 551.041 nm: eta 0.129 and 0.124375, k 3.25 and 3.348125.
    EXPECT_NEAR((*named_spectrum("metal-Ag-eta"))(550), 0.12478, 1e-5);
    EXPECT_NEAR((*named_spectrum("metal-Ag-k"))(550), 3.33960, 1e-5);
}

TEST(NamedSpectra, values_at_the_ends_hold_to_the_ends_of_the_visible) {
    const Spectrum lamp = *named_spectrum("stdillum-F2");
    EXPECT_FLOAT_EQ(lamp(360), lamp(380));
    EXPECT_FLOAT_EQ(lamp(830), lamp(780));
    EXPECT_GT(lamp(830), 0);
}

TEST(NamedSpectra, names_are_listed_sorted_and_found) {
    const auto names = named_spectra();
    EXPECT_EQ(names.size(), 16U + 7U + 14U);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const auto& name : names) {
        const auto curve = named_spectrum(name);
        ASSERT_TRUE(curve);
        for (int nm = kFirstNm; nm <= kLastNm; ++nm)
            ASSERT_GE((*curve)(static_cast<float>(nm)), 0) << name << ' ' << nm;
    }
    EXPECT_FALSE(named_spectrum("glass-BK8"));
}

}  // namespace
}  // namespace sunfleck::engine
