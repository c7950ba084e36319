// What a surface does to a photon's flux: roulette keeps it, and what grew fades before roulette.
#include "photon/turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck {
namespace {

/// A photon that comes straight down onto a grey floor.
PhotonState falling(float throughput) {
    PhotonState state;
    state.flux = Spectrum(6 * throughput);
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

/// One turn, the photon then falling again. @param roulette  the number that it reads.
/// @return whether it survives.
bool bounce(PhotonState& state, float albedo, float roulette) {
    const std::uint32_t number = slot(state.bounces, BounceSlot::roulette);
    const auto read = [&](std::uint32_t index) {
        return to_fraction(index == number ? static_cast<double>(roulette) : 0.5);
    };
    const Turn turn = draw_turn(read, Lambert{Spectrum(albedo)}, floor_hit(), state);
    const bool survives = take_turn(turn, state);
    state.direction = {0, 0, -1};
    return survives;
}

TEST(Turn, roulette_keeps_the_flux) {
    PhotonState state = falling(1);
    ASSERT_TRUE(bounce(state, 0.5F, 0.49F));
    EXPECT_NEAR(state.flux[0], 6, 1e-5);
    EXPECT_EQ(state.throughput, 1);
    EXPECT_FALSE(bounce(state, 0.5F, 0.51F));
}

TEST(Turn, a_photon_that_grew_fades_before_roulette_begins) {
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

TEST(Turn, what_a_medium_took_counts) {
    PhotonState state = falling(0.5F);
    EXPECT_FALSE(bounce(state, 0.5F, 0.26F));
    state = falling(0.5F);
    ASSERT_TRUE(bounce(state, 0.5F, 0.24F));
    EXPECT_NEAR(state.flux[0], 6, 1e-5);
}

/// It grazes the facet, but not the smooth surface that the shading normal stands for.
TEST(Turn, a_shading_normal_makes_a_photon_heavy) {
    PhotonState state = falling(1);
    state.direction = {0.995F, 0, -std::sqrt(1 - 0.995F * 0.995F)};
    Hit hit = floor_hit();
    hit.shading_normal = Vec3(-0.6F, 0, 0.8F);
    const auto read = [](std::uint32_t) { return to_fraction(0.5); };
    const Turn turn = draw_turn(read, Lambert{Spectrum(0.8F)}, hit, state);
    EXPECT_GT(turn.throughput, 2);
    EXPECT_NEAR(turn.flux[0], 6 * turn.throughput, 1e-4);
    ASSERT_TRUE(take_turn(turn, state));
    EXPECT_NEAR(state.flux[0], 6 * state.throughput, 1e-4);
}

}  // namespace
}  // namespace sunfleck
