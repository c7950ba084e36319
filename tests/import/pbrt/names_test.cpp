// Names of objects and materials, as scenes have them.
#include "import/pbrt/reader.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

SceneNames pbrt_names(const std::string& world) {
    return Scene(read_pbrt_text("Camera \"perspective\"\nWorldBegin\n" + world, "folder/a.pbrt"))
        .names();
}

TEST(Names, of_shapes_are_their_types_and_places) {
    const SceneNames names = pbrt_names("Shape \"sphere\"\nShape \"disk\"\n");
    EXPECT_EQ(names.shapes, (std::vector<std::string>{"sphere a.pbrt:3", "disk a.pbrt:4"}));
    EXPECT_TRUE(names.instances.empty());
}

TEST(Names, of_materials_are_given_ones_or_their_types_and_places) {
    const SceneNames names = pbrt_names(
        "Material \"conductor\"\nShape \"sphere\"\nNamedMaterial \"red\"\nShape \"sphere\"\n"
        "MakeNamedMaterial \"red\" \"string type\" \"diffuse\"\n");
    EXPECT_EQ(names.materials, (std::vector<std::string>{"default", "conductor a.pbrt:3", "red"}));
}

TEST(Names, of_instances_are_those_of_their_objects) {
    const SceneNames names = pbrt_names(
        "ObjectBegin \"tree\"\nShape \"sphere\"\nShape \"disk\"\nObjectEnd\n"
        "ObjectInstance \"tree\"\nTranslate 3 0 0\nObjectInstance \"tree\"\n");
    EXPECT_EQ(names.instances, (std::vector<std::string>{"tree", "tree"}));
    Hit hit;
    hit.instance = 1;
    EXPECT_EQ(names.object_at(hit), "tree");
    hit.instance = kNone;
    hit.shape = 1;
    EXPECT_EQ(names.object_at(hit), "disk a.pbrt:5");
}

}  // namespace
}  // namespace sunfleck::engine
