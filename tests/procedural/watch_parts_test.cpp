// The parts of the watch: closed, full, in their places.

#include "procedural/watch_parts.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(WatchParts, are_closed_and_face_out) {
    for (const Mesh& part : {watch_case(), watch_lid(), watch_cover(), watch_dial(),
                             watch_fittings(), watch_chain(), watch_hands()}) {
        EXPECT_TRUE(open_edges(part).empty());
        EXPECT_GT(volume(part), 0);
    }
}

TEST(WatchParts, stay_above_the_table) {
    for (const Mesh& part : {watch_case(), watch_lid(), watch_fittings(), watch_chain()})
        for (const auto& p : part.points) ASSERT_GT(p[2], 0);
}

/// Over every point of the hands, and over some of the dial's, are the cover's two faces.
TEST(WatchParts, the_cover_is_over_dial_and_hands) {
    const Mesh cover = watch_cover();
    const auto expect_covered = [&](const Mesh& part, std::size_t stride) {
        for (std::size_t i = 0; i < part.points.size(); i += stride) {
            const auto& p = part.points[i];
            const Vec3d from(p[0] + 1e-4, p[1] + 2e-4, p[2]);
            ASSERT_EQ(all_hits(cover, from, Vec3d(0, 0, 1)).size(), 2) << from;
        }
    };
    expect_covered(watch_hands(), 3);
    expect_covered(watch_dial(), 20);
    expect_covered(watch_marks(), 300);
}

/// The lid gathers the sun: lines of one direction, thrown back by its hollow side, come closer.
TEST(WatchParts, the_lid_is_hollow_towards_the_dial) {
    const Mesh lid = watch_lid();
    Vec3d low(1e9);
    Vec3d high(-1e9);
    for (const auto& p : lid.points)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min<double>(low[axis], p.at(static_cast<std::size_t>(axis)));
            high[axis] = std::max<double>(high[axis], p.at(static_cast<std::size_t>(axis)));
        }
    const double middle_height = (low.z + high.z) / 2;
    const auto depth = [&](double y, double z) {
        double first = 1e9;
        for (const MeshHit& hit : all_hits(lid, {20, y, z}, {-1, 0, 0}))
            first = std::min(first, hit.distance);
        return first;
    };
    const double slope = (depth(0.01, middle_height + 10) + depth(0.01, middle_height - 10)) / 2;
    EXPECT_GT(depth(0.01, middle_height), slope + 0.5);
}

}  // namespace
}  // namespace sunfleck::engine
