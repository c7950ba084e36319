// Daylight against the model itself: its colours, and its illuminance by quadrature.
#include "sky/daylight.h"

#include "math/trigonometry.h"
#include "sky/compass.h"
#include "sky/curves.h"
#include "sky/sun_disc.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

const Daylight kHigh{.sun = {.azimuth = 130, .elevation = 50}};
const Daylight kLow{.sun = {.azimuth = 280, .elevation = 4}, .turbidity = 5};

SkyModel model_of(const Daylight& daylight) {
    return SkyModel({.elevation = daylight.sun.elevation * kPiDouble / 180,
                     .turbidity = daylight.turbidity,
                     .ground_albedo = daylight.ground_albedo});
}

/// The colour of the light's spectrum from a direction.
Vec3d colour_from(const ImageInfiniteLight& sky, const Vec3d& w) {
    const EnvironmentRadiance met = sky.environment_radiance(Vec3(w), Vec3(w));
    const Spectrum factor = Spectrum::rgb_unbounded(met.rgb.value_or(Vec3(1)));
    std::vector<TabulatedSpectrum::Point> product;
    for (int nm = 360; nm <= 830; nm += 5) {
        const auto x = static_cast<float>(nm);
        product.push_back({x, sky.curve(x) * factor(x) * met.factor});
    }
    return Vec3d(Spectrum::table(product).to_rgb());
}

TEST(Daylight, has_the_colours_of_the_model) {
    const CurveColours colour_of;
    for (const Daylight& daylight : {kHigh, kLow}) {
        const SkyModel model = model_of(daylight);
        const ImageInfiniteLight sky = lights_of(daylight, Affine()).sky;
        for (const Vec3d& towards :
             {Vec3d(0, 0, 1), Vec3d(1, 0, 0.2), Vec3d(-1, 1, 0.5), Vec3d(-0.2, -1, 0.05)}) {
            const Vec3d w = towards.normalized();
            const Vec3d expected = colour_of(model.sky(w.z, w.dot(direction_to(daylight.sun))));
            const Vec3d found = colour_from(sky, w);
            const double largest = std::max({expected.x, expected.y, expected.z});
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c] / largest, expected[c] / largest, 0.02)
                    << w << ' ' << c << ' ' << daylight.sun.elevation;
        }
    }
}

/// Midpoints of angles, with the spectra of the model: no map, no colours.
TEST(Daylight, lights_the_ground_as_the_model_does) {
    for (const Daylight& daylight : {kHigh, kLow}) {
        const SkyModel model = model_of(daylight);
        const Vec3d to_sun = direction_to(daylight.sun);
        SkyCurve sum{};
        constexpr int kSteps = 180;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < 4 * kSteps; ++j) {
                const SinCos zenith = sin_cos_2pi((i + 0.5) / (4 * kSteps));
                const SinCos azimuth = sin_cos_2pi((j + 0.5) / (4 * kSteps));
                const Vec3d w(zenith.sin * azimuth.cos, zenith.sin * azimuth.sin, zenith.cos);
                const double step = kPiDouble / 2 / kSteps;
                sum = sum_of(sum, w.z * zenith.sin * step * step, model.sky(w.z, w.dot(to_sun)));
            }
        const double expected = spectrum_of(sum).luminance();
        const ImageInfiniteLight sky = lights_of(daylight, Affine()).sky;
        const double found = illuminance_from_above(*sky.image, sky.map) * sky.curve.luminance();
        EXPECT_NEAR(found / expected, 1, 0.01) << daylight.sun.elevation;
    }
}

/// Rings of the disc, each with the darkening of its own.
TEST(Daylight, has_a_sun_that_is_darker_at_its_limb) {
    const double elevation = kHigh.sun.elevation * kPiDouble / 180;
    const SkyModel model = model_of(kHigh);
    const SunLight sun = lights_of(kHigh, Affine()).sun;
    SkyCurve sum{};
    constexpr int kRings = 200;
    const double radius = 0.255 * kPiDouble / 180;
    for (int i = 0; i < kRings; ++i) {
        const double r = (i + 0.5) / kRings;
        double power = 1;
        for (const SkyCurve& coefficient : SkyModel::limb_darkening()) {
            sum = sum_of(sum, power * 2 * kPiDouble * r * radius * radius / kRings,
                         product_of(model.sun(elevation), coefficient));
            power *= std::sqrt(1 - r * r);
        }
    }
    EXPECT_NEAR(sun.curve.luminance() / spectrum_of(sum).luminance(), 1, 1e-3);
    EXPECT_NEAR(683 * sun.curve.luminance(), 77.8e3, 0.1e3);  // lux
    const auto at = [&](double angle) {
        const Vec3d to_sun = direction_to(kHigh.sun);
        const Vec3d aside = to_sun.cross(Vec3d(0, 0, 1)).normalized();
        const Vec3 w((to_sun + aside * (angle * kPiDouble / 180)).normalized());
        return sun.environment_radiance(w, w).factor;
    };
    EXPECT_GT(at(0), 1.15F * at(0.2));
    EXPECT_GT(at(0.2), 1.2F * at(0.25));
    EXPECT_EQ(at(0.26), 0);
}

TEST(Daylight, stands_in_the_south_at_noon_whatever_axis_is_up) {
    const Vec3d noon = direction_to({.azimuth = 180, .elevation = 45});
    EXPECT_TRUE(
        compass(UpAxis::z, 0).vector(noon).equalWithAbsError(Vec3d(0, -1, 1).normalized(), 1e-12));
    EXPECT_TRUE(
        compass(UpAxis::y, 0).vector(noon).equalWithAbsError(Vec3d(0, 1, 1).normalized(), 1e-12));
    // North a quarter turn clockwise, at +x: the south is at -x.
    EXPECT_TRUE(
        compass(UpAxis::z, 90).vector(noon).equalWithAbsError(Vec3d(-1, 0, 1).normalized(), 1e-12));
}

}  // namespace
}  // namespace sunfleck::engine
