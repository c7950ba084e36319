// Libraries of materials: their names, and those that are missing.
#include "import/part/libraries.h"

#include "part_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::kTetrahedron;

class Libraries : public testing_support::PartFolder {
protected:
    void SetUp() override {
        PartFolder::SetUp();
        written("red.mtl", "newmtl red\nPm 1\n");
        written("my blue.mtl", "newmtl blue\nPm 1\nnewmtl red\nPm 0\n");
        written("other", "newmtl green\nPm 1\n");
        written("sub/deep.mtl", "newmtl deep\nPm 1\nmap_Pr a.pfm\n");
        written("sub/a.pfm", testing_support::pfm({1, 1, 1}));
    }
    /// Returns the kind of the material of that name.
    std::string kind(const std::string& statements, const std::string& name) const {
        const SceneDescription scene = read(statements + "usemtl " + name + "\n" + kTetrahedron);
        return std::string(name_of(scene.materials[scene.shapes[0].material]));
    }
};

TEST_F(Libraries, have_blanks_in_their_names_or_are_several) {
    EXPECT_EQ(kind("mtllib my blue.mtl\n", "blue"), "conductor");
    EXPECT_EQ(kind("mtllib red.mtl my blue.mtl\n", "blue"), "conductor");
    EXPECT_EQ(kind("mtllib my blue.mtl red.mtl\n", "red"), "coateddiffuse");
    EXPECT_EQ(kind("mtllib red.mtl\nmtllib my blue.mtl\n", "red"), "conductor");
    EXPECT_EQ(kind("mtllib red.mtl other\n", "green"), "conductor");
}

/// Pictures lie beside the library; paths may be those of Windows.
TEST_F(Libraries, lie_in_folders_of_any_system) {
    EXPECT_EQ(kind("mtllib sub\\deep.mtl\n", "deep"), "conductor");
    EXPECT_EQ(kind("mtllib C:\\Users\\me\\red.mtl\n", "red"), "conductor");
    EXPECT_EQ(kind("mtllib ./sub/../red.mtl\n", "red"), "conductor");
}

TEST_F(Libraries, that_are_missing_are_all_named_at_once) {
    written("some.mtl", "newmtl a\nmap_Kd no.png\nmap_d neither.png\n");
    EXPECT_EQ(fault_of("mtllib some.mtl none.mtl\nusemtl a\n" + kTetrahedron),
              "a.obj: 3 files are missing: \"none.mtl\" (a.obj:1:7); \"no.png\" (some.mtl:2:1); "
              "\"neither.png\" (some.mtl:3:1); put them there");
    EXPECT_EQ(
        fault_of("mtllib none.mtl\nusemtl a\n" + kTetrahedron),
        "a.obj: a file is missing: \"none.mtl\" (a.obj:1:7); put it there, or name a material "
        "with --material");
}

TEST_F(Libraries, that_are_missing_give_way_to_a_named_material) {
    ImportSettings settings;
    settings.material = "gold";
    const SceneDescription scene = read("mtllib none.mtl\nusemtl a\n" + kTetrahedron, settings);
    EXPECT_EQ(name_of(scene.materials[scene.shapes[0].material]), "conductor");
    EXPECT_NE(warnings_of(scene).find("library of materials \"none.mtl\" (a.obj:1:7) is missing"),
              std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
