// Pictures of few pixels, enlarged.
#include "display/enlarged.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Enlarged, repeats_each_pixel_where_it_lies) {
    const Picture small{2, 2, {{"R", {1, 2, 3, 4}}, {"d.Z", {5, 6, 7, 8}}}, {}};
    const Picture large{5,
                        3,
                        {{"R", {1, 1, 1, 2, 2, 1, 1, 1, 2, 2, 3, 3, 3, 4, 4}},
                         {"d.Z", {5, 5, 5, 6, 6, 5, 5, 5, 6, 6, 7, 7, 7, 8, 8}}},
                        {}};
    EXPECT_EQ(enlarged(small, 5, 3), large);
    EXPECT_EQ(enlarged(small, 2, 2), small);
}

}  // namespace
}  // namespace sunfleck::engine
