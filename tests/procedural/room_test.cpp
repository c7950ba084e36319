// The furnished room: the sun comes in through its panes only.

#include "procedural/room.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Room, gets_the_sun_through_panes_only) {
    expect_sun_through_panes_only("room", {-2.5, 0.1, 0.1}, {2.4, 5.5, 2.6}, {0.76, -0.24, 0.6});
}

}  // namespace
}  // namespace sunfleck::engine
