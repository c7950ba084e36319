// Where things stand: medians of boxes, and the grid of origins.
#include "geometry/middle.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Bounds box_around(const Vec3d& center, double half) {
    Bounds box;
    box.extend(center - Vec3d(half));
    box.extend(center + Vec3d(half));
    return box;
}

TEST(Middle, a_dome_around_many_things_does_not_say_where_they_are) {
    std::vector<Bounds> boxes = {box_around(Vec3d(0), 1e6)};
    for (int i = 0; i < 4; ++i) boxes.push_back(box_around(Vec3d(5e5 + i, 4.5e6, 0), 1));
    const Middle middle = middle_of(boxes);
    EXPECT_NEAR(middle.center.x, 5e5, 4);
    EXPECT_EQ(middle.center.y, 4.5e6);
    EXPECT_LT(middle.radius, 6);
}

TEST(Middle, nothing_is_at_the_origin) {
    EXPECT_EQ(middle_of({Bounds()}).radius, 0);
    EXPECT_EQ(origin_near(middle_of({})), Vec3d(0));
}

TEST(Middle, what_is_near_the_origin_stays_there) {
    EXPECT_EQ(origin_near({Vec3d(31, -31, 5), 1}), Vec3d(0));
    EXPECT_EQ(origin_near({Vec3d(31e6, 0, 0), 1e6}), Vec3d(0));
}

TEST(Middle, origins_are_within_a_radius_and_move_with_things_by_whole_steps) {
    const Middle near_it{Vec3d(3, -2, 1), 5};
    for (const double far : {1e3, 1e6, 1e9}) {
        Middle moved = near_it;
        const double by = std::round(far / 8) * 8;
        moved.center += Vec3d(by, -by, 0);
        const Vec3d origin = origin_near(moved);
        EXPECT_EQ(origin, Vec3d(by, -by, 0));
        EXPECT_LT((moved.center - origin).length(), 8);
    }
}

}  // namespace
}  // namespace sunfleck::engine
