// The statue: one scene, two cameras; a knot without a seam.

#include "procedural/statue.h"

#include "mesh_checks.h"
#include "procedural/scenes.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Statue, is_the_same_from_far_and_near) {
    const std::vector<SceneFile> far = make_scene("statue-far");
    const std::vector<SceneFile> near = make_scene("statue-near");
    ASSERT_EQ(far.size(), near.size());
    for (std::size_t i = 1; i < far.size(); ++i) EXPECT_EQ(far[i].bytes, near[i].bytes);
    const auto world = [](const SceneFile& file) {
        return file.bytes.substr(file.bytes.find("WorldBegin"));
    };
    EXPECT_EQ(world(far[0]), world(near[0]));
    EXPECT_NE(far[0].bytes, near[0].bytes);
}

TEST(Statue, the_knot_is_closed_and_faces_out) {
    const Mesh knot = fluted_knot(240, 40);
    EXPECT_EQ(knot.triangles.size(), 2 * 240 * 40);
    EXPECT_TRUE(open_edges(knot).empty());
    EXPECT_GT(volume(knot), 0);
    for (std::size_t i = 0; i < 240; ++i) {  // the flutes meet at the seam
        const Vec3d step = corner(knot, static_cast<std::uint32_t>((i + 1) % 240 * 40)) -
                           corner(knot, static_cast<std::uint32_t>(i * 40));
        ASSERT_LT(step.length(), 2.6);
    }
}

}  // namespace
}  // namespace sunfleck::engine
