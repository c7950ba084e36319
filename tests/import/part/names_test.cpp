// Objects and groups of OBJ, and the names of other parts.
#include "import/part/reader.h"
#include "part_files.h"
#include "scene/scene.h"

namespace sunfleck::engine {
namespace {

class PartNamesOf : public testing_support::PartFolder {
protected:
    SceneNames names(const std::string& file, const std::string& text) {
        ImportSettings settings;
        settings.material = "gold";
        return Scene(read_part(written(file, text), settings)).names();
    }
    static std::string name_at(const SceneNames& names, std::uint32_t primitive) {
        Hit hit;
        hit.primitive = primitive;
        return names.object_at(hit);
    }
};

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST_F(PartNamesOf, objects_are_kept_within_one_shape) {
    const SceneNames found = names(
        "a.obj", kCorners + "f 1 2 3\no cup\ng side\nf 1 2 4\no plate\nf 2 3 4\no cup\nf 1 3 4\n");
    ASSERT_EQ(found.shapes.size(), 2U);  // and the ground
    EXPECT_EQ(name_at(found, 0), "a");
    EXPECT_EQ(name_at(found, 1), "cup");
    EXPECT_EQ(name_at(found, 2), "plate");
    EXPECT_EQ(name_at(found, 3), "cup");
    EXPECT_EQ(found.shapes[1], "ground");
}

TEST_F(PartNamesOf, groups_stand_for_objects_where_there_are_none) {
    const SceneNames found = names("a.obj", kCorners + "g one two\nf 1 2 3\nf 2 3 4\n");
    EXPECT_EQ(name_at(found, 0), "one two");
    EXPECT_EQ(found.parts[0], nullptr);
    EXPECT_EQ(found.shapes[0], "one two");
}

TEST_F(PartNamesOf, a_part_without_names_has_that_of_its_file) {
    const SceneNames found = names("bracket.obj", kCorners + "f 1 2 3\n");
    EXPECT_EQ(found.shapes[0], "bracket");
    EXPECT_EQ(found.materials[0], "gold");
}

}  // namespace
}  // namespace sunfleck::engine
