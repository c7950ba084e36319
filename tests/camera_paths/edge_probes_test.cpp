// Edge probes: their mean is one over the share of the disc that lies on a surface.
#include "camera_paths/edge_probes.h"

#include "math/statistics.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

const std::string kFloor = quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0");

VisiblePoint point_at(const Vec3& position) {
    VisiblePoint point;
    point.disc.position = position;
    point.disc.normal = Vec3(0, 0, 1);
    point.disc.radius = 0.1F;
    point.disc.indirect_radius_scale = 2;
    point.disc.kinds = static_cast<std::uint8_t>(PhotonKind::direct) |
                       static_cast<std::uint8_t>(PhotonKind::indirect);
    return point;
}

/// Means over many pixels. @param shapes  around the point.
struct Probed {
    double sharp = 0;
    double indirect = 0;

    double need_sight = 0;

    Probed(const std::string& shapes, const Vec3& position, Probes probes = Probes::of_surface) {
        constexpr std::uint32_t kPixels = 20'000;
        const Scene scene =
            scene_of(view("0 -1 3  0 0 0  0 1 0", 40, 4) + "LightSource \"distant\"\n" + shapes);
        const PassScene pass(scene, {1, 0});
        for (std::uint32_t i = 0; i < kPixels; ++i) {
            std::array<VisiblePoint, 1> points = {point_at(position)};
            probe_edges(pass, points, probes, PassId{5, 0}.stream(Purpose::edge_probe, i));
            sharp += points[0].disc_over_surface / double{kPixels};
            indirect += points[0].indirect_disc_over_surface / double{kPixels};
            if (points[0].needs_sight) need_sight += 1 / double{kPixels};
        }
    }
};

TEST(EdgeProbes, are_one_over_the_share_of_the_disc) {
    const std::string floor = diffuse("0.5 0.5 0.5") + kFloor;
    const Probed middle(floor, {0, 0, 0});
    EXPECT_NEAR(middle.sharp, 1, 1e-9);
    EXPECT_NEAR(middle.indirect, 1, 1e-9);
    const Probed edge(floor, {0.99999F, 0, 0});
    EXPECT_NEAR(edge.sharp, 2, 0.02);  // standard errors are below .3%
    EXPECT_NEAR(edge.indirect, 2, 0.02);
    const Probed corner(floor, {0.99999F, -0.99999F, 0});
    EXPECT_NEAR(corner.sharp, 4 * (1 - std::pow(0.75, 16)), 0.07);
    // The edge is a radius away from one disc, and half a radius from the other.
    const Probed near(floor, {0.9F, 0, 0});
    EXPECT_NEAR(near.sharp, 1, 1e-9);
    EXPECT_NEAR(near.indirect, 1 / 0.8045, 0.02);
}

/// On a ball there is more surface than disc: 2 (1 - cos) / sin^2 of the cap's angle. The mean
/// cosine is .2% more than one over that.
TEST(EdgeProbes, know_that_curved_surfaces_are_larger) {
    const Probed on_ball(
        diffuse("0.5 0.5 0.5") + "Translate 0 0 -.2\nShape \"sphere\" \"float radius\" .2\n",
        {0, 0, 0});
    EXPECT_NEAR(on_ball.sharp, 0.25 / (2 * (1 - std::sqrt(0.75))), 0.01);
}

/// Photons are stored at all of a surface that is there in part, at none of a mirror or a null
/// interface.
TEST(EdgeProbes, look_for_surfaces_that_store_photons) {
    const std::string more = quad("1 -1 0  3 -1 0  3 1 0  1 1 0");
    const std::string floor = diffuse("0.5 0.5 0.5") + kFloor;
    const Vec3 edge(0.99999F, 0, 0);
    EXPECT_NEAR(Probed(floor + more, edge).sharp, 1, 1e-9);
    EXPECT_NEAR(Probed(floor + "Material \"conductor\"\n" + more, edge).sharp, 2, 0.07);
    EXPECT_NEAR(Probed(floor + "Material \"interface\"\n" + more, edge).sharp, 2, 0.07);
    const std::string half =
        "Shape \"trianglemesh\" \"float alpha\" .5 \"point3 P\" [1 -1 0  3 -1 0  3 1 0  1 1 0] "
        "\"integer indices\" [0 1 2  0 2 3]\n";
    EXPECT_NEAR(Probed(floor + half, edge).sharp, 1, 1e-9);
}

/// What lies above is no part of the disc, and hides none of it; a sheet in its flatness is a part.
TEST(EdgeProbes, go_through_what_lies_above) {
    const std::string floor = diffuse("0.5 0.5 0.5") + kFloor;
    const Vec3 edge(0.99999F, 0, 0);
    const auto above = [](const std::string& z) {
        return quad("-3 -3 " + z + "  3 -3 " + z + "  3 3 " + z + "  -3 3 " + z);
    };
    EXPECT_NEAR(Probed(floor + above(".05"), {0, 0, 0}).sharp, 1, 1e-9);
    EXPECT_NEAR(Probed(floor + above(".05"), edge).sharp, 2, 0.07);
    EXPECT_NEAR(Probed(floor + above(".02"), edge).sharp, 1, 1e-9);
}

/// A wall on the floor, half a small radius away, hides a fifth of the small disc.
TEST(EdgeProbes, leave_out_what_is_hidden) {
    const std::string shapes =
        diffuse("0.5 0.5 0.5") + kFloor + quad("-.05 -1 0  -.05 1 0  -.05 1 1  -.05 -1 1");
    const Vec3 middle(0, 0, 0);
    const Probed of_surface(shapes, middle);
    EXPECT_NEAR(of_surface.sharp, 1, 1e-9);
    EXPECT_EQ(of_surface.need_sight, 0);
    const Probed of_sight(shapes, middle, Probes::of_sight);
    EXPECT_NEAR(of_sight.sharp, 1 / 0.8045, 0.02);
    EXPECT_NEAR(of_sight.need_sight, 1, 1e-9);
    const Probed of_trial(shapes, middle, Probes::of_trial);
    EXPECT_NEAR(of_trial.sharp, of_sight.sharp, 1e-9);
    EXPECT_GT(of_trial.need_sight, 0.3);  // .2 of the small disc, .35 of the other
    EXPECT_LT(of_trial.need_sight, 0.95);
    EXPECT_EQ(Probed(diffuse("0.5 0.5 0.5") + kFloor, middle, Probes::of_trial).need_sight, 0);
}

/// A wall beside a cylinder's axis hides .35 of it for indirect photons. Cylinders are probed even
/// where discs are not; narrow ones, for other photons, are not.
TEST(EdgeProbes, know_what_a_wall_leaves_of_a_cylinder) {
    const Scene scene =
        scene_of(view("0 -1 3  0 0 0  0 1 0", 40, 4) + "LightSource \"distant\"\n" +
                 diffuse("0.5 0.5 0.5") + quad("-.05 -9 -9  -.05 9 -9  -.05 9 9  -.05 -9 9"));
    const PassScene pass(scene, {1, 0});
    VisiblePoint cylinder = point_at({0, 0, 0});
    cylinder.disc.half_length = 1;
    cylinder.disc.kinds = static_cast<std::uint8_t>(cylinder.disc.kinds << kKindsInMedia);
    constexpr std::uint32_t kPixels = 20'000;
    double sharp = 0;
    double indirect = 0;
    double need_sight = 0;
    for (std::uint32_t i = 0; i < kPixels; ++i) {
        std::array<VisiblePoint, 1> points = {cylinder};
        probe_edges(pass, points, Probes::none, PassId{5, 0}.stream(Purpose::edge_probe, i));
        sharp = std::max(sharp, double{points[0].disc_over_surface});
        indirect += points[0].indirect_disc_over_surface / double{kPixels};
        need_sight += points[0].needs_sight ? 1 / double{kPixels} : 0;
    }
    EXPECT_EQ(sharp, 1);
    EXPECT_NEAR(indirect, 1 / 0.6575, 0.03);
    EXPECT_GT(need_sight, 0.3);
    EXPECT_LT(need_sight, 0.95);
}

}  // namespace
}  // namespace sunfleck::engine
