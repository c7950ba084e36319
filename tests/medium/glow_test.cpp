// Light that a medium emits along a way, against sums over small steps.
#include "core/random.h"
#include "medium/density_samples.h"
#include "medium/glow_along.h"
#include "medium/glow_power.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace sunfleck::engine {
namespace {

Affine unit_box() {
    return Affine(Matrix());
}

DensityGrid lattice(const std::vector<float>& values, const Voxel& parts) {
    return density_of_parts(values, parts, unit_box());
}

std::shared_ptr<const Density> shared(DensityGrid grid) {
    return std::make_shared<const Density>(std::move(grid));
}

Medium hot_smoke() {
    Glow glow;
    glow.radiance = Spectrum::constant(3);
    glow.factor = shared(lattice({0, 2, 1, 0, 0, 4, 0, 1, 1, 0}, {10, 1, 1}));
    glow.heat = Heat{shared(lattice({900, 2500, 0, 1800}, {4, 1, 1})), 100, 1.5F};
    const DensityGrid density = lattice({0.2F, 3, 0, 0, 5, 1}, {6, 1, 1});
    glow.power = std::make_shared<const DensityGrid>(glow_power(density, glow));
    return {Spectrum::rgb_unbounded({1, 2, 4}), Spectrum::rgb_unbounded({2, 1, 0.5F}), 0,
            shared(density), std::make_shared<const Glow>(glow)};
}

Wavelengths some_wavelengths() {
    return Wavelengths::of_pass({1, 2});
}

SampledSpectrum summed(const SampledMedium& medium, const Wavelengths& wavelengths,
                       const Ray& way) {
    SampledSpectrum sum;
    constexpr int kSteps = 20'000;
    const float step = way.length / kSteps;
    SampledSpectrum left(1);
    for (int i = 0; i < kSteps; ++i) {
        const float at = (static_cast<float>(i) + 0.5F) * step;
        const Vec3 point = way.origin + way.direction * at;
        const float density = density_at(medium, point);
        sum += glow_at(medium, wavelengths, point) * medium.absorption * left * (density * step);
        for (std::size_t k = 0; k < kWavelengths; ++k)
            left[k] *= std::exp(-(medium.absorption[k] + medium.scattering[k]) * density * step);
    }
    return sum;
}

const Ray kAcross{Vec3(-0.3F, 0.4F, 0.3F), Vec3(0.96F, 0, 0.28F), 1.5F};

TEST(Glow, is_the_sum_over_a_way_where_it_does_not_vary) {
    Medium smoke = hot_smoke();
    smoke.glow = std::make_shared<const Glow>(Glow{Spectrum::rgb_illuminant({3, 2, 1})});
    const Wavelengths wavelengths = some_wavelengths();
    const SampledMedium medium = sampled(smoke, wavelengths);
    const SampledSpectrum expected = summed(medium, wavelengths, kAcross);
    const SampledSpectrum light =
        glow_along(medium, wavelengths, kAcross, SampledSpectrum(1), 0.5F);
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(light[i] / expected[i], 1, 2e-3F);
}

TEST(Glow, of_an_endless_way_is_that_of_a_thick_medium) {
    Medium even{Spectrum::constant(2), Spectrum::constant(6)};
    even.glow = std::make_shared<const Glow>(Glow{Spectrum::constant(5)});
    const Wavelengths wavelengths = some_wavelengths();
    const SampledSpectrum light = glow_along(sampled(even, wavelengths), wavelengths,
                                             {Vec3(0), Vec3(1, 0, 0)}, SampledSpectrum(1), 0.5F);
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_FLOAT_EQ(light[i], 5.0F / 4);
}

/// Stratified samples: their mean is the sum within .5%, and none is far from it.
TEST(Glow, is_met_by_points_where_it_varies) {
    const Medium smoke = hot_smoke();
    const Wavelengths wavelengths = some_wavelengths();
    const SampledMedium medium = sampled(smoke, wavelengths);
    const SampledSpectrum expected = summed(medium, wavelengths, kAcross);
    constexpr int kSamples = 1 << 16;
    SampledSpectrum sum;
    float greatest = 0;
    for (int i = 0; i < kSamples; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) / kSamples;
        const SampledSpectrum light =
            glow_along(medium, wavelengths, kAcross, SampledSpectrum(1), u);
        sum += light / kSamples;
        greatest = std::max(greatest, light.sum() / expected.sum());
    }
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(sum[i] / expected[i], 1, 5e-3F);
    EXPECT_LT(greatest, 12);
}

/// Between points of the density's lattice at which nothing glows there is light all the same.
TEST(GlowPower, misses_nothing) {
    Glow glow;
    glow.radiance = Spectrum::constant(1);
    std::vector<float> spot(31, 0);
    spot[15] = 1;  // a thirtieth of the box, between two of its parts
    spot[3] = 0.1F;
    glow.factor = shared(lattice(spot, {31, 1, 1}));
    const DensityGrid density = lattice({1, 1, 1, 0}, {4, 1, 1});
    const DensityGrid power = glow_power(density, glow);
    for (int i = 0; i <= 1000; ++i) {
        const Vec3 point(static_cast<float>(i) / 1000, 0.5F, 0.5F);
        if (density.at(point) > 0) {
            EXPECT_GT(power.at(point), 0.03F * density.at(point) * glow.factor_at(point)) << point;
        }
    }
}

TEST(GlowPower, is_zero_where_all_is_cold) {
    Glow glow;
    glow.radiance = Spectrum::constant(1);
    glow.heat = Heat{shared(lattice({90, 50}, {2, 1, 1}))};
    EXPECT_EQ(glow_power(lattice({1, 1}, {2, 1, 1}), glow).greatest(), 0);
}

}  // namespace
}  // namespace sunfleck::engine
