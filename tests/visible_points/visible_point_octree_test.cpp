// The octree loses no disc, and heights fall with the distance from all of them.
#include "visible_points/visible_point_octree.h"

#include "core/parallel.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kRadius = 20;  // of the scene
const Vec3d kCentre(1, -2, 0.5);
constexpr int kMaxDepth = 64;

VisiblePoint point_at(const Vec3& position, float radius) {
    VisiblePoint point;
    point.disc.position = position;
    point.disc.radius = radius;
    point.disc.indirect_radius_scale = 1.6F;
    point.disc.normal = Vec3(0, 0, 1);
    point.disc.kinds = 15;
    return point;
}

Vec3 random_place(RandomStream& stream) {
    const auto coordinate = [&] { return 20 * stream.next_float() - 10; };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
}

/// Radii over four decades.
std::vector<VisiblePoint> random_points(int count) {
    RandomStream stream(1, Purpose::test, 0, 0);
    std::vector<VisiblePoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const Vec3 place = random_place(stream);
        points.push_back(point_at(place, std::exp2(-13 * stream.next_float())));
    }
    return points;
}

// 200,000 photons that discs take, most of them near the rim: none in a cell that is not full.
TEST(VisiblePointOctree, whatever_a_disc_accepts_is_in_a_full_cell) {
    const auto points = random_points(500);
    const VisiblePointOctree octree(points, kCentre, kRadius);
    RandomStream stream(1, Purpose::test, 1, 0);
    int taken = 0;
    while (taken < 200'000) {
        const auto which = static_cast<std::size_t>(stream.next() * 500);
        const Disc& disc = points[which].disc;
        Photon photon;
        photon.normal = disc.normal;
        const float phi = 2 * kPi * stream.next_float();
        constexpr std::array kKinds = {PhotonKind::caustic, PhotonKind::indirect,
                                       PhotonKind::long_specular_chain};
        photon.kind = kKinds.at(static_cast<std::size_t>(taken) % kKinds.size());
        const float radius = disc.radius_for(photon.kind);
        const float r = radius * std::sqrt(0.7F + 0.31F * stream.next_float());
        const float z = 0.3F * radius * (2 * stream.next_float() - 1);
        photon.position = disc.position + Vec3(r * std::cos(phi), r * std::sin(phi), z);
        if (!accepts(disc, photon, kMaxDepth)) continue;
        ++taken;
        ASSERT_EQ(octree.height(photon.position), VisiblePointOctree::kFull) << which;
    }
}

// A place D away from a single disc shares no cell with it that is much smaller than D.
TEST(VisiblePointOctree, heights_fall_with_the_distance) {
    const Vec3 position(3.1F, -4.2F, 0.7F);
    const float radius = 1e-3F;
    const std::array one{point_at(position, radius)};
    const VisiblePointOctree octree(one, kCentre, kRadius);
    RandomStream stream(1, Purpose::test, 2, 0);
    double near = 0;
    double far = 0;
    for (int i = 0; i < 10'000; ++i) {
        const double distance = 0.02 * std::pow(200.0, stream.next());
        const Vec3 way = (random_place(stream) - random_place(stream)).normalized();
        const int height = octree.height(position + way * static_cast<float>(distance));
        // Cells of that depth are 2.5 radii of the scene over 2^depth wide: a place that shares
        // one with the disc is within its diagonal, give or take the disc itself.
        EXPECT_LE(distance, 1.74 * 2.5 * kRadius / std::exp2(height) + 4 * double{radius});
        (distance < 0.3 ? near : far) += height;
    }
    EXPECT_GT(near, 1.5 * far);
}

TEST(VisiblePointOctree, more_discs_never_lower_a_place) {
    const auto points = random_points(300);
    const VisiblePointOctree some({points.begin(), points.begin() + 100}, kCentre, kRadius);
    const VisiblePointOctree all(points, kCentre, kRadius);
    RandomStream stream(1, Purpose::test, 3, 0);
    int higher = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 place = random_place(stream);
        ASSERT_LE(some.height(place), all.height(place));
        higher += some.height(place) < all.height(place) ? 1 : 0;
    }
    EXPECT_GT(higher, 1000);
}

// 40,000 discs of all sizes in no order, so that those of all parts lie among each other.
TEST(VisiblePointOctree, built_in_parts_it_is_the_same) {
    auto points = random_points(40'000);
    for (VisiblePoint& point : points) point.disc.radius *= 0.2F;  // or all would be full
    const auto built = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        return VisiblePointOctree(points, kCentre, kRadius);
    };
    const VisiblePointOctree whole = built(1);
    const VisiblePointOctree parts = built(8);
    RandomStream stream(1, Purpose::test, 4, 0);
    std::array<int, VisiblePointOctree::kFull + 1> heights{};
    for (int i = 0; i < 200'000; ++i) {
        const Vec3 place = random_place(stream);
        ASSERT_EQ(parts.height(place), whole.height(place));
        ++heights.at(static_cast<std::size_t>(whole.height(place)));
    }
    EXPECT_GT(heights.at(VisiblePointOctree::kFull), 1000);
    EXPECT_GT(std::count_if(heights.begin(), heights.end(), [](int n) { return n > 1000; }), 3);
}

TEST(VisiblePointOctree, large_discs_small_scenes_and_places_outside) {
    const std::array large{point_at(Vec3(0), 500)};
    const VisiblePointOctree covered(large, kCentre, kRadius);
    EXPECT_EQ(covered.height(Vec3(9, 9, 9)), VisiblePointOctree::kFull);
    EXPECT_EQ(covered.height(Vec3(-9, 9, -9)), VisiblePointOctree::kFull);
    EXPECT_EQ(covered.height(Vec3(1e4F, 0, 0)), 0);
    const VisiblePointOctree empty({}, kCentre, kRadius);
    EXPECT_EQ(empty.height(Vec3(0)), 0);
    const std::array small{point_at(Vec3(1), 1e-6F)};
    const VisiblePointOctree point(small, Vec3d(1), 0);
    EXPECT_GE(point.height(Vec3(1)), 0);
}

}  // namespace
}  // namespace sunfleck::engine
