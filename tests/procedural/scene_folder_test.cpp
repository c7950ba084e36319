// Scenes put together: head, small meshes in the text, large ones in files.

#include "procedural/scene_folder.h"

#include "procedural/surfaces.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(SceneFolder, puts_small_meshes_into_the_text_and_large_ones_beside_it) {
    SceneFolder folder({"lamp", "a lamp"}, {"Unit: metres; z is up", "Camera \"perspective\"\n"});
    folder.text("MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\n");
    folder.add("small", "a", box_mesh({0, 0, 0}, {1, 1, 1}));
    folder.add("large", "a", torus(2, 1, 8, 8));
    const std::vector<SceneFile> files = std::move(folder).files();
    ASSERT_EQ(files.size(), 2);
    EXPECT_EQ(files[0].name, "lamp.pbrt");
    EXPECT_EQ(files[1].name, "geometry/large.ply");
    const std::vector<Mesh> meshes = scene_meshes(files);
    ASSERT_EQ(meshes.size(), 2);
    EXPECT_EQ(meshes[0].triangles.size(), 12);
    EXPECT_EQ(meshes[1].triangles.size(), 128);
    EXPECT_NE(files[0].bytes.find("\"lamp.exr\"\n    \"integer xresolution\" 512"),
              std::string::npos);
}

TEST(SceneFolder, every_mark_is_replaced) {
    EXPECT_EQ(replaced("@A@ and @A@", "@A@", "x"), "x and x");
}

}  // namespace
}  // namespace sunfleck::engine
