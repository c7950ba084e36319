// Tests core/warnings.h: each warning once, in the order of first appearance, with its count.
#include "core/warnings.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Warnings, are_said_once_and_counted) {
    Warnings warnings;
    EXPECT_TRUE(warnings.entries().empty());
    warnings.add({"a.pbrt", 3, 1}, "no fog: rendered clear");
    warnings.add({"a.pbrt", 5, 1}, "no hair: left out");
    warnings.add({"b.pbrt", 9, 2}, "no fog: rendered clear");
    warnings.add({"b.pbrt", 10, 2}, "no fog: rendered clear");

    ASSERT_EQ(warnings.entries().size(), 2U);
    EXPECT_EQ(warnings.entries()[0].line(),
              "a.pbrt:3:1: warning: no fog: rendered clear (3 times)");
    EXPECT_EQ(warnings.entries()[1].line(), "a.pbrt:5:1: warning: no hair: left out");
}

}  // namespace
}  // namespace sunfleck::engine
