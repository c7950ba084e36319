// The box: its meshes by number of triangles.

#include "procedural/box.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Box, has_the_triangles_of_its_nine_meshes_and_two_sources) {
    std::vector<std::size_t> counts;
    for (const Part& part : parts_of("box")) counts.push_back(part.mesh.triangles.size());
    EXPECT_EQ(counts, (std::vector<std::size_t>{170, 2, 2, 720, 720, 320, 672, 640, 216, 2, 2}));
}

}  // namespace
}  // namespace sunfleck::engine
