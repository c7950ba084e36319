// The reference integrators on pictures whose values are known in closed form.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class ReferenceClosedForms : public ::testing::TestWithParam<Integrator> {
protected:
    RenderSettings settings() const {
        RenderSettings settings;
        settings.integrator = GetParam();
        settings.photon.paths_per_pass = 1000;
        settings.transport.max_depth = depth_;
        return settings;
    }

    int depth_ = 8;

    /// Of the columns from `begin` on; all 8 of them, unless told. @param passes  of mlt.
    Estimate brightness(const Scene& scene, int begin = 0, int end = 8,
                        std::uint32_t passes = 1) const {
        RenderSettings with = settings();
        if (GetParam() != Integrator::mlt) passes = 32;
        return Estimate::over(16, [&](int i) {
            with.seed = static_cast<std::uint64_t>(i);
            return luminance(render_mean(scene, with, passes).mean(begin, 0, end, 8));
        });
    }
};

std::string room() {
    return "ReverseOrientation\n" + box({-1, -1, -1}, {1, 1, 1});
}

/// A floor of albedo 0.5 under a point light: radiance = rho / pi * I cos(theta) / d^2.
TEST_P(ReferenceClosedForms, inverse_square_and_cosine) {
    const Scene scene =
        scene_of(view("0 0 4  0 0 0  0 1 0", 20, 8) +
                 "LightSource \"point\" \"point3 from\" [0 0 2] \"rgb I\" [8 8 8]\n" +
                 diffuse("0.5 0.5 0.5") + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0"));
    const double half = 4 * std::tan(10 * kPiDouble / 180);
    double expected = 0;
    constexpr int kSide = 200;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double px = (2 * (x + 0.5) / kSide - 1) * half;
            const double py = (2 * (y + 0.5) / kSide - 1) * half;
            const double d2 = px * px + py * py + 4;
            expected += 0.5 / kPiDouble * 8 * (2 / std::sqrt(d2)) / d2 / (kSide * kSide);
        }
    EXPECT_LT(worst_ratio(brightness(scene), {expected, 0}), 0.02);
}

/// Inside a closed box of albedo rho whose walls emit 1, radiance is 1 / (1 - rho) everywhere, but
/// for what is cut: rho^(n + 1) of it after n events.
TEST_P(ReferenceClosedForms, furnace_box) {
    const Scene scene = scene_of(view("0 0 -0.9  0 0.1 1  0 1 0", 70, 8) +
                                 "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                                 diffuse("0.5 0.5 0.5") + room());
    depth_ = 6;
    EXPECT_LT(worst_ratio(brightness(scene), {2 - 1.0 / 64, 0}), 0.02);
}

/// The same, where the cut is seen.
TEST_P(ReferenceClosedForms, cut_at_the_greatest_depth) {
    const Scene scene = scene_of(view("0 0 -0.9  0 0.1 1  0 1 0", 70, 8) +
                                 "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                                 diffuse("0.8 0.8 0.8") + room());
    depth_ = 2;
    EXPECT_LT(worst_ratio(brightness(scene), {1 + 0.8 + 0.64, 0}), 0.02);
}

/// A floor in the sun, one half of it a hundred times darker: chains that start elsewhere than
/// where their target says make that half too bright, whatever the sum.
TEST_P(ReferenceClosedForms, a_dark_half_beside_a_bright_one) {
    const Scene scene = scene_of(
        view("0 0 4  0 0 0  0 1 0", 20, 8) + "LightSource \"distant\" \"point3 from\" [0 0 2]\n" +
        diffuse("0.9 0.9 0.9") + quad("-3 -3 0  0 -3 0  0 3 0  -3 3 0") +
        diffuse("0.009 0.009 0.009") + quad("0 -3 0  3 -3 0  3 3 0  0 3 0"));
    Estimate one = brightness(scene, 0, 4, 6);
    Estimate other = brightness(scene, 4, 8, 6);
    if (one.mean < other.mean) std::swap(one, other);
    EXPECT_LT(worst_ratio({other.mean * 100, other.error * 100}, one), 0.25)
        << other.mean / one.mean;
}

/// A closed box in the sun is black inside.
TEST_P(ReferenceClosedForms, no_light_in_a_closed_box) {
    const Scene scene = scene_of(view("0 0 -0.9  0 0.1 1  0 1 0", 70, 12) + R"(
LightSource "distant" "point3 from" [1 2 3] "point3 to" [0 0 0] "float scale" 1000
LightSource "infinite" "rgb L" [5 5 5]
)" + diffuse("0.5 0.5 0.5") + room());
    EXPECT_EQ(render_mean(scene, settings(), 8).mean(), Vec3d(0));
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceClosedForms,
                         ::testing::Values(Integrator::path, Integrator::light, Integrator::bdpt,
                                           Integrator::mlt),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace sunfleck::engine
