// The sky model against values of its authors' own program.
#include "sky/sky_model.h"

#include "math/trigonometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>

namespace sunfleck::engine {
namespace {

double at(const SkyCurve& curve, double nm) {
    const double along = (nm - 320) / 40;
    const auto i = std::min(static_cast<std::size_t>(along), kSkyWavelengths - 2);
    return curve[i] + (along - static_cast<double>(i)) * (curve[i + 1] - curve[i]);
}

SkyCurve darkening_at(double cosine) {
    SkyCurve sum{};
    double power = 1;
    for (const SkyCurve& coefficient : SkyModel::limb_darkening()) {
        for (std::size_t w = 0; w < kSkyWavelengths; ++w) sum[w] += coefficient[w] * power;
        power *= cosine;
    }
    return sum;
}

double radians(double degrees) {
    return degrees * kPiDouble / 180;
}

/// Angles in degrees; of the sun's disc: from its middle.
struct Known {
    double turbidity, albedo, elevation, zenith, from_sun, nm, sky, sky_and_sun;
};

constexpr std::array<Known, 11> kKnown = {{
    {1, 0, 35, 28.9, 83.896526, 455, 0.0589823122, 0.0589823122},
    {1, 1, 2, 62.3, 52.532896, 455, 0.029084305, 0.029084305},
    {6.5, 1, 2, 88, 0.2, 720, 0.373900208, 645.644462},
    {1, 0.3, 35, 79, 87.744173, 455, 0.187590043, 0.187590043},
    {1, 0, 88, 2, 0.2, 320, 0.0602034354, 1580.21275},
    {1, 0.3, 60, 54.6, 26.216690, 633, 0.0451732112, 0.0451732112},
    {1, 1, 35, 55, 0.2, 550, 0.10682197, 16272.9652},
    {1, 0, 88, 84.6, 84.394249, 720, 0.0445187578, 0.0445187578},
    {1, 0, 60, 30, 0.2, 400, 0.117352645, 8627.86427},
    {1, 1, 2, 63.7, 144.023153, 633, 0.0214450775, 0.0214450775},
    {10, 1, 10, 80, 0.2, 720, 0.780243808, 1579.7033},
}};

void expect_known(const Known& k) {
    const SkyModel model(
        {.elevation = radians(k.elevation), .turbidity = k.turbidity, .ground_albedo = k.albedo});
    const double sky =
        at(model.sky(std::cos(radians(k.zenith)), std::cos(radians(k.from_sun))), k.nm);
    EXPECT_NEAR(sky / k.sky, 1, 1e-5) << k.nm << ' ' << k.zenith;
    if (k.from_sun > 0.255) return;
    const double ratio = std::sin(radians(k.from_sun)) / std::sin(radians(0.255));
    const double sun = at(model.sun(radians(90 - k.zenith)), k.nm) *
                       at(darkening_at(std::sqrt(1 - ratio * ratio)), k.nm);
    EXPECT_NEAR((sky + sun) / k.sky_and_sun, 1, 1e-5) << k.nm << ' ' << k.zenith;
}

TEST(SkyModel, has_the_values_of_its_authors) {
    for (const Known& k : kKnown) expect_known(k);
}

TEST(SkyModel, has_all_shared_values_of_its_authors) {
    std::ifstream file(std::string(SUNFLECK_SOURCE_DIR) + "/../shared/data/sky/check-values.csv");
    if (!file) GTEST_SKIP() << "there is no ../shared/data/sky";
    int count = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream in(line);
        Known k{};
        in >> k.turbidity >> k.albedo >> k.elevation >> k.zenith >> k.from_sun >> k.nm >> k.sky >>
            k.sky_and_sun;
        expect_known(k);
        ++count;
    }
    EXPECT_EQ(count, 60);
}

TEST(SkyModel, is_finite_everywhere) {
    for (const double turbidity : {1.0, 1.7, 10.0})
        for (const double elevation : {0.0, 0.3, 45.0, 90.0}) {
            const SkyModel model({.elevation = radians(elevation), .turbidity = turbidity});
            for (const double up : {0.0, 1e-9, 0.5, 1.0})
                for (const double to_sun : {-1.0, 0.0, 1.0})
                    for (const double value : model.sky(up, to_sun))
                        EXPECT_TRUE(std::isfinite(value)) << elevation << ' ' << up;
            for (const double value : model.sun(radians(elevation))) EXPECT_GE(value, 0);
        }
}

}  // namespace
}  // namespace sunfleck::engine
