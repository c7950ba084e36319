// Laws that infinite lights keep, over all examples: what rays that leave the scene meet is what
// direct samples and photons bring.
//
// Fixed seeds; significance 1e-4.
#include "core/random.h"
#include "laws/light_examples.h"
#include "laws/significance.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;

class EnvironmentLaws : public testing::TestWithParam<LightExample> {
protected:
    const Light& light() const { return light_; }
    Vec2 random_2d() { return {random_.next_float(), random_.next_float()}; }

    const Light light_ = GetParam().make();
    RandomStream random_{7, Purpose::test, 0, 0};
};

/// The two halves of MIS agree but where rounding takes a direction over the edge of a texel.
TEST_P(EnvironmentLaws, radiance_is_that_which_samples_bring) {
    int lost = 0;
    for (int i = 0; i < 10000; ++i) {
        const auto s = sample_direct(light(), GetParam().point, random_2d(), kExampleSphere);
        ASSERT_TRUE(s);
        const EnvironmentRadiance met =
            environment_radiance(light(), GetParam().point, s->direction);
        if (!(std::abs(met.pdf / *s->pdf - 1) < 1e-4F)) {
            ++lost;
            continue;
        }
        ASSERT_NEAR(s->factor * *s->pdf / met.factor, 1, 1e-4F);
        ASSERT_EQ(met.rgb, s->rgb);
        ASSERT_FALSE(met.rgb && std::abs(met.rgb->dot({0.2126F, 0.7152F, 0.0722F}) - 1) > 1e-5F);
    }
    EXPECT_LE(lost, 5);
}

/// Means of rgb * factor: photons and direct samples bring the picture's integral, in colour, and
/// so do uniform directions. Sees 3%. (Photons through a portal: LightLaws.)
TEST_P(EnvironmentLaws, all_ways_bring_the_same_colour) {
    constexpr int kSamples = 1 << 18;
    const double disc = kPiDouble * kExampleSphere.radius * kExampleSphere.radius;
    const bool is_portal = std::holds_alternative<PortalLight>(light());
    std::array<Vec3d, 3> sums = {Vec3d(0), Vec3d(0), Vec3d(0)};
    const auto add = [&](std::size_t way, double factor, const std::optional<Vec3>& rgb) {
        sums.at(way) += Vec3d(rgb.value_or(Vec3(1))) * factor / kSamples;
    };
    for (int i = 0; i < kSamples; ++i) {
        const EmissionDimensions u = {0.5, 0.5, random_.next(), random_.next()};
        const Emission e = sample_emission(light(), u, kExampleSphere);
        add(0, is_portal ? 0 : e.factor / disc, e.rgb);
        const auto s = sample_direct(light(), GetParam().point, random_2d(), kExampleSphere);
        add(1, static_cast<double>(s->factor), s->rgb);
        const Vec3 w(uniform_sphere({random_.next(), random_.next()}));
        const EnvironmentRadiance met = environment_radiance(light(), GetParam().point, w);
        add(2, static_cast<double>(met.factor) * 4 * kPiDouble, met.rgb);
    }
    for (int c = 0; c < 3; ++c)
        for (const std::size_t way : {is_portal ? 1U : 0U, 1U})
            EXPECT_NEAR(sums.at(way)[c], sums[2][c], 0.03 * sums[2][c]) << way << ' ' << c;
}

/// The density of direct samples, in bins of directions, is the one that environment_radiance()
/// tells.
TEST_P(EnvironmentLaws, directions_have_their_density) {
    constexpr int kSide = 16;
    constexpr int kSamples = 1 << 18;
    constexpr int kFine = 72;                          // midpoints along the side of a bin
    std::vector<Vec2d> bins(kSide * kSide, Vec2d(0));  // samples, expected
    const auto bin = [](const Vec2d& place) {
        const auto cell = [](double x) { return std::min(static_cast<int>(x * kSide), kSide - 1); };
        return static_cast<std::size_t>(cell(place.y) * kSide + cell(place.x));
    };
    for (int i = 0; i < kSamples; ++i) {
        const auto s = sample_direct(light(), GetParam().point, random_2d(), kExampleSphere);
        bins[bin(sphere_to_square(Vec3d(s->direction)))].x += 1;
    }
    constexpr int kAll = kSide * kFine;
    for (int y = 0; y < kAll; ++y)
        for (int x = 0; x < kAll; ++x) {
            const Vec2d place((x + 0.5) / kAll, (y + 0.5) / kAll);
            const double pdf = static_cast<double>(
                environment_radiance(light(), GetParam().point, Vec3(uniform_sphere(place))).pdf);
            bins[bin(place)].y += pdf * 4 * kPiDouble / (double{kAll} * kAll) * kSamples;
        }
    double statistic = 0;
    int used = 0;
    for (const Vec2d& b : bins) {
        if (b.y < 20) continue;
        statistic += (b.x - b.y) * (b.x - b.y) / b.y;
        ++used;
    }
    EXPECT_GT(used, std::holds_alternative<PortalLight>(light()) ? 25 : 100);
    EXPECT_GT(chi_square_p(statistic, used), kSignificance) << statistic << " of " << used;
}

INSTANTIATE_TEST_SUITE_P(Examples, EnvironmentLaws, testing::ValuesIn(infinite_examples()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine
