// What a surface does to a photon's flux: Russian roulette keeps it, and what grew fades before
// Russian roulette.
#include "photon/scattering_event.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

/// A photon that comes straight down onto a grey floor.
PhotonState falling(float throughput) {
    PhotonState state;
    state.flux = SampledSpectrum(6 * throughput);
    state.direction = {0, 0, -1};
    state.throughput = throughput;
    return state;
}

Hit floor_hit() {
    Hit hit;
    hit.normal = hit.shading_normal = {0, 0, 1};
    hit.tangent = {1, 0, 0};
    return hit;
}

/// One event, the photon then falling again. @param Russian roulette  the number that it reads.
/// @return whether it survives.
bool bounce(PhotonState& state, float albedo, float roulette) {
    const std::uint32_t number = dimension(state.bounces, BounceDimension::roulette);
    const auto read = [&](std::uint32_t index) {
        return to_fraction(index == number ? static_cast<double>(roulette) : 0.5);
    };
    const ScatteringEvent event =
        sample_scattering(read, Lambert{SampledSpectrum(albedo)}, floor_hit(), state);
    const bool survives = apply_event(event, state);
    state.direction = {0, 0, -1};
    return survives;
}

TEST(ScatteringEvent, roulette_keeps_the_flux) {
    PhotonState state = falling(1);
    ASSERT_TRUE(bounce(state, 0.5F, 0.49F));
    EXPECT_NEAR(state.flux[0], 6, 1e-5);
    EXPECT_EQ(state.throughput, 1);
    EXPECT_FALSE(bounce(state, 0.5F, 0.51F));
}

TEST(ScatteringEvent, a_photon_that_grew_fades_before_roulette_begins) {
    PhotonState state = falling(3);
    ASSERT_TRUE(bounce(state, 0.5F, 0.999F));
    EXPECT_NEAR(state.flux[0], 9, 1e-5);
    EXPECT_NEAR(state.throughput, 1.5, 1e-6);
    EXPECT_FALSE(bounce(state, 0.5F, 0.76F));
    state = falling(1.5F);
    ASSERT_TRUE(bounce(state, 0.5F, 0.74F));
    EXPECT_NEAR(state.flux[0], 6, 1e-5);
    EXPECT_EQ(state.throughput, 1);
}

TEST(ScatteringEvent, what_a_medium_took_counts) {
    PhotonState state = falling(0.5F);
    EXPECT_FALSE(bounce(state, 0.5F, 0.26F));
    state = falling(0.5F);
    ASSERT_TRUE(bounce(state, 0.5F, 0.24F));
    EXPECT_NEAR(state.flux[0], 6, 1e-5);
}

/// It grazes the facet, but not the smooth surface that the shading normal stands for.
TEST(ScatteringEvent, a_shading_normal_makes_a_photon_heavy) {
    PhotonState state = falling(1);
    state.direction = {0.995F, 0, -std::sqrt(1 - 0.995F * 0.995F)};
    Hit hit = floor_hit();
    hit.shading_normal = Vec3(-0.6F, 0, 0.8F);
    const auto read = [](std::uint32_t) { return to_fraction(0.5); };
    const ScatteringEvent event =
        sample_scattering(read, Lambert{SampledSpectrum(0.8F)}, hit, state);
    EXPECT_GT(event.throughput, 2);
    EXPECT_NEAR(event.flux[0], 6 * event.throughput, 1e-4);
    ASSERT_TRUE(apply_event(event, state));
    EXPECT_NEAR(state.flux[0], 6 * state.throughput, 1e-4);
}

/// A photon that meets a facet under a normal 37 degrees from its own.
struct Tilted {
    PhotonState state = falling(1);
    Hit hit = floor_hit();
    Tilted() {
        state.direction = {0.6F, 0, -0.8F};
        hit.shading_normal = Vec3(-0.6F, 0, 0.8F);
    }

    /// The mean of f(flux, direction) over a grid of the numbers that make a direction.
    template <class Surface, class F>
    double mean(const Surface& surface, const F& f) {
        constexpr int kSteps = 512;
        double sum = 0;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const auto read = [&](std::uint32_t index) {
                const int step =
                    index == dimension(0, BounceDimension::direction_u) ? i / kSteps : i % kSteps;
                return to_fraction((step + 0.5) / kSteps);
            };
            const ScatteringEvent event = sample_scattering(read, surface, hit, state);
            sum += f(event);
        }
        return sum / kSteps / kSteps;
    }
};

/// By quadrature over the hemisphere of the shading normal: f |n_g.w| of the light on the surface,
/// which the shading normal makes 1 / 0.8 times that on the facet.
TEST(ScatteringEvent, lambertian_flux_goes_where_bsdf_and_normals_say) {
    Tilted at;
    const Lambert grey{SampledSpectrum(0.5F)};
    constexpr int kSteps = 512;
    const Frame frame(at.hit.shading_normal);
    Vec3d expected(0);
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double z = (i / kSteps + 0.5) / kSteps;
        const double angle = (i % kSteps + 0.5) / kSteps * 2 * kPiDouble;
        const double across = std::sqrt(1 - z * z);
        const Vec3d w(
            frame.to_world(Vec3(Vec3d(across * std::cos(angle), across * std::sin(angle), z))));
        expected += w * (6 * 0.5 / kPiDouble / 0.8 * std::abs(w.z));
    }
    expected *= 2 * kPiDouble / kSteps / kSteps;
    for (int axis = 0; axis < 3; ++axis) {
        const auto value = [&](const ScatteringEvent& event) {
            return static_cast<double>(event.flux[0] * event.direction[axis]);
        };
        EXPECT_NEAR(at.mean(grey, value), expected[axis], 0.002) << axis;
    }
    const auto below = [](const ScatteringEvent& event) {
        return event.direction.z < 0 ? 1.0 : 0.0;
    };
    EXPECT_NEAR(at.mean(grey, below), (1 - 0.8) / 2, 0.002);
}

TEST(ScatteringEvent, no_direction_of_lambertian_flux_weighs_more_than_another) {
    Tilted at;
    const Lambert grey{SampledSpectrum(0.5F)};
    const float expected = 0.5F / 0.8F;
    EXPECT_NEAR(at.mean(grey, [](const ScatteringEvent& event) { return event.throughput; }),
                expected, 1e-4);
    const auto spread = [&](const ScatteringEvent& event) {
        return std::abs(event.throughput - expected);
    };
    EXPECT_NEAR(at.mean(grey, spread), 0, 1e-5);
    EXPECT_GT(at.mean(Bsdf{grey}, spread), 0.1);
}

}  // namespace
}  // namespace sunfleck::engine
