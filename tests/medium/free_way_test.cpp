// Free paths through media that vary: the same as through an even medium, by
// amounts.
#include "medium/free_way.h"

#include "core/random.h"
#include "medium/density_samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

SampledMedium fog(const Density* density) {
    SampledMedium medium;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        medium.absorption[i] = 0.1F * static_cast<float>(i);
        medium.scattering[i] = 0.5F + 0.4F * static_cast<float>(i);
    }
    medium.scatters = true;
    medium.density = density;
    return medium;
}

/// A box from 0 to 1 that is twice as dense behind the middle of x as before
/// it.
Density steps() {
    std::vector<float> values;
    for (int i = 0; i < 40 * 8 * 8; ++i) values.push_back(i % 40 < 20 ? 1 : 2);
    Affine box;
    box.origin = Vec3d(0);
    return density_of_parts(values, {40, 8, 8}, box);
}

const Ray kThrough{Vec3(-1, 0.5F, 0.5F), Vec3(1, 0, 0)};

TEST(FreeWay, loses_what_an_even_medium_does_over_the_amount) {
    const Density density = steps();
    const SampledMedium even = fog(nullptr);
    const SampledMedium varied = fog(&density);
    const float whole = amount(varied, kThrough);
    EXPECT_GT(whole, 1.4F);
    const SampledSpectrum left = transmittance(varied, kThrough);
    const SampledSpectrum expected = transmittance(even, {Vec3(0), Vec3(1, 0, 0), whole});
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_FLOAT_EQ(left[i], expected[i]);
}

/// Flights end in proportion to scattered light: by halves of the box, within
/// four standard errors of 1/500 each. Would see a density that is left out, or
/// weighs twice.
TEST(FreeWay, ends_where_the_density_scatters) {
    const Density density = steps();
    const SampledMedium varied = fog(&density);
    RandomStream random(9, Purpose::test, 0, 0);
    constexpr int kFlights = 60000;
    std::array<double, 3> light{};  // before the middle, behind it, passed
    for (int i = 0; i < kFlights; ++i) {
        const Flight flight = fly(varied, kThrough, SampledSpectrum(1), random.next_float());
        const std::size_t part = !flight.is_scattered ? 2 : flight.distance < 1.5F ? 0 : 1;
        light.at(part) += static_cast<double>(flight.weight[3]) / kFlights;
        if (flight.is_scattered) {
            EXPECT_GT(density_at(density, Vec3(flight.distance - 1, 0.5F, 0.5F)), 0);
        }
    }
    const double a = static_cast<double>(varied.absorption[3]);
    const double s = static_cast<double>(varied.scattering[3]);
    const auto scattered = [&](float from, float to) {
        const auto lost = [&](float x) {
            return std::exp(-(a + s) * static_cast<double>(amount(
                                           varied, {kThrough.origin, kThrough.direction, x})));
        };
        return s / (a + s) * (lost(from) - lost(to));
    };
    EXPECT_NEAR(light[0], scattered(0, 1.5F), 0.008);
    EXPECT_NEAR(light[1], scattered(1.5F, 3), 0.008);
    EXPECT_NEAR(light[2], static_cast<double>(transmittance(varied, kThrough)[3]), 0.008);
}

/// Chances of parts are integrals of the density, and distances invert them.
TEST(FreeWay, tells_chances_by_distances) {
    const Density density = steps();
    const SampledMedium varied = fog(&density);
    const FreeWay path(varied, kThrough, SampledSpectrum(1));
    float before = 0;
    for (int i = 0; i < 100; ++i) {
        const float from = 1 + 0.01F * static_cast<float>(i);
        const float chance = path.chance_between(from, from + 0.01F);
        before += chance;
        EXPECT_NEAR(chance, 0.01F * path.density(from + 0.005F), 0.02F * chance) << i;
    }
    EXPECT_NEAR(before, path.chance(), 1e-5F);
    const float middle = path.distance_at(path.chance() / 2);
    EXPECT_NEAR(path.chance_between(0, middle), path.chance() / 2, 1e-5F);
}

}  // namespace
}  // namespace sunfleck::engine
