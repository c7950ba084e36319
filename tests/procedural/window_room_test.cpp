// The room: walls closed but for the window, and the window closed by the pane.

#include "procedural/window_room.h"

#include "core/random.h"
#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck {
namespace {

TEST(WindowRoom, the_masonry_is_closed_and_faces_out) {
    const Mesh walls = room_walls();
    EXPECT_TRUE(open_edges(walls).empty());
    EXPECT_NEAR(volume(walls), 5.4 * 4.4 * 3.1 - 5.0 * 4.0 * 2.7 - 0.6 * 0.7 * 0.2, 1e-5);
}

TEST(WindowRoom, the_pane_is_a_closed_slab) {
    const Mesh pane = window_pane();
    EXPECT_TRUE(open_edges(pane).empty());
    EXPECT_NEAR(volume(pane), 0.62 * 0.72 * 0.006, 1e-6);
}

/// From a point in the room every line meets the walls, or leaves by both faces of the pane.
TEST(WindowRoom, light_enters_only_through_the_pane) {
    const Mesh walls = room_walls();
    const Mesh pane = window_pane();
    RandomStream random(2, Purpose::test, 0, 0);
    int outward = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d from(4.8 * random.next() - 2.4, 3.8 * random.next() - 1.9, 2.6 * random.next());
        // Half of the lines aim around the window, half anywhere.
        const bool aimed = i % 2 == 0;
        const Vec3d to =
            aimed ? Vec3d(random.next(), 2.1, 1.2 + random.next())
                  : Vec3d(10 * random.next() - 5, 10 * random.next() - 5, 10 * random.next() - 5);
        const std::size_t at_walls = all_hits(walls, from, to - from).size();
        ASSERT_EQ(at_walls % 2, 0) << "the room and the outside are both free of masonry";
        if (at_walls > 0) continue;
        ++outward;
        ASSERT_EQ(all_hits(pane, from, to - from).size(), 2);
    }
    EXPECT_GT(outward, 2000);
}

}  // namespace
}  // namespace sunfleck
