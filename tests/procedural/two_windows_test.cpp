// The hall: the sun comes in through its panes only.

#include "procedural/two_windows.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(TwoWindows, the_hall_gets_the_sun_through_panes_only) {
    expect_sun_through_panes_only("two-windows", {-3.9, 0.1, 0.1}, {3.9, 8.9, 4.4},
                                  {0.75, -0.14, 0.65});
}

}  // namespace
}  // namespace sunfleck::engine
