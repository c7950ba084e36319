// Files that a scene names: missing ones, names from other systems, faults in them, floods of them.
#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";

std::string mesh(const std::string& name) {
    return "Shape \"plymesh\" \"string filename\" \"" + name + "\"\n";
}

TEST(FileAccess, that_are_missing_are_told_at_once) {
    const std::string message =
        world_error(mesh("a.ply") + mesh("b.ply") + "Include \"c.pbrt\"\n" + mesh("a.ply") +
                    "LightSource \"infinite\" \"string filename\" \"d.exr\"\n" +
                    "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"e.png\"\n" +
                    "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"\n" +
                    "Material \"dielectric\" \"spectrum eta\" \"f.spd\" Shape \"sphere\"\n" +
                    "Material \"measured\" \"string filename\" \"g.bsdf\" Shape \"sphere\"\n" +
                    "NamedMaterial \"made in c.pbrt\" Shape \"sphere\"\n");
    EXPECT_EQ(message.find("main.pbrt:2:1: 6 files are missing"), 0U) << message;
    for (const char* part : {"\n  \"a.ply\" (main.pbrt:2:1)", "\n  \"b.ply\" (main.pbrt:3:1)",
                             "\"c.pbrt\"", "\"d.exr\"", "\"f.spd\"", "\"g.bsdf\""})
        EXPECT_TRUE(contains(message, part)) << part << " in " << message;
}

TEST(FileAccess, that_are_missing_as_images_are_told_with_all_others) {
    const std::string message = world_error(
        mesh("a.ply") + "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"e.png\"\n" +
        "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"\n");
    EXPECT_TRUE(contains(message, "2 files are missing")) << message;
    EXPECT_TRUE(contains(message, "\"e.png\" (main.pbrt:3:1)")) << message;
    EXPECT_EQ(world_error(mesh("a.ply")), "main.pbrt:2:1: there is no file \"a.ply\"; make it");
}

TEST(FileAccess, that_are_missing_are_listed_up_to_twenty) {
    std::string text;
    for (int i = 0; i < 23; ++i) text += mesh(std::to_string(i) + ".ply");
    const std::string message = world_error(text);
    EXPECT_TRUE(contains(message, "23 files are missing"));
    EXPECT_TRUE(contains(message, "\"19.ply\""));
    EXPECT_FALSE(contains(message, "\"20.ply\""));
    EXPECT_TRUE(contains(message, "and 3 more"));
}

TEST(FileAccess, with_backslashes_are_found_by_slashes) {
    const MemoryFiles files = {{"tex/tiles/new.ply", kPly + "3 0 1 2\n"}};
    for (const char* name : {R"(tex\\tiles\\new.ply)", R"(tex\tiles\new.ply)",
                             R"(tex/tiles\new.ply)", R"(.\tex\tiles\new.ply)"}) {
        const SceneDescription scene = read_world(mesh(name), files);
        EXPECT_EQ(scene.shapes.size(), 1U) << name;
        EXPECT_EQ(warnings_with(scene, "read as slashes"), 1) << name;
    }
    const MemoryFiles odd = {{"a\\b.ply", kPly + "3 0 1 2\n"}, {"a/b.ply", ""}};
    EXPECT_EQ(warnings_with(read_world(mesh(R"(a\\b.ply)"), odd), "slashes"), 0);
    EXPECT_TRUE(contains(world_error(mesh(R"(tex\wall.ply)")), R"("tex\wall.ply")"));
    const MemoryFiles parts = {{"parts/b.pbrt", "Shape \"sphere\""}};
    EXPECT_EQ(read_world(R"(Include "parts\b.pbrt")", parts).shapes.size(), 1U);
}

TEST(FileAccess, whose_faults_are_told_name_the_statement_too) {
    const auto expect = [](const std::string& text, const std::string& name,
                           const std::string& bytes, const std::string& place) {
        const std::string message = world_error(text, {{name, bytes}});
        EXPECT_EQ(message.find(name + place), 0U) << message;
        EXPECT_TRUE(contains(message, "(asked for at main.pbrt:2:")) << message;
    };
    expect(mesh("a.ply"), "a.ply", kPly + "3 0 1 9\n", ": face 0: ");
    expect(mesh("a.ply"), "a.ply", "ply\nformat utf8 1.0\n", ":2:8: ");
    expect("Material \"diffuse\" \"spectrum reflectance\" \"a.spd\" Shape \"sphere\"", "a.spd",
           "400 1\n500 x", ":2:5: ");
    expect("LightSource \"infinite\" \"string filename\" \"a.exr\"", "a.exr", "no picture", ": ");
    expect(
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\" Material "
        "\"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"",
        "a.png", "\x89PNG\r\n", ": ");
    expect("Material \"measured\" \"string filename\" \"a.bsdf\" Shape \"sphere\"", "a.bsdf",
           "PK\x03\x04", ": is a ZIP archive");
}

TEST(FileAccess, of_other_content_are_named) {
    const std::string lfs = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
    EXPECT_TRUE(contains(error_of(lfs), "git lfs pull"));
    EXPECT_TRUE(contains(error_of(std::string("\xFF\xFEL\0", 4)), "UTF-16"));
    EXPECT_TRUE(contains(error_of(""), "is empty"));
    EXPECT_TRUE(contains(world_error("Include \"a.pbrt\"", {{"a.pbrt", "<html>"}}), "a web page"));
    EXPECT_EQ(world_error("Include \"a.pbrt\" Shape \"sphere\"", {{"a.pbrt", ""}}), "");
    EXPECT_TRUE(contains(world_error(mesh("a.ply"), {{"a.ply", lfs}}), "git lfs pull"));
    EXPECT_TRUE(contains(world_error("Material \"diffuse\" \"spectrum reflectance\" \"a.spd\" "
                                     "Shape \"sphere\"",
                                     {{"a.spd", "{\"a\": 1}"}}),
                         "a JSON text"));
}

/// Each file includes the next one `times` times.
MemoryFiles tree(int depth, int times, const std::string& leaf) {
    MemoryFiles files = {{std::to_string(depth), leaf}};
    for (int i = 0; i < depth; ++i)
        for (int j = 0; j < times; ++j)
            files[std::to_string(i)] += "Include \"" + std::to_string(i + 1) + "\"\n";
    return files;
}

TEST(FileAccess, may_be_included_as_often_as_there_is_work_for) {
    const SceneDescription scene =
        read_world("ObjectBegin \"o\" Shape \"sphere\" ObjectEnd Include \"0\"",
                   tree(4, 20, "ObjectInstance \"o\""));
    EXPECT_EQ(scene.instances.size(), 160000U);
    EXPECT_EQ(scene.files.size(), 5U);
}

TEST(FileAccess, that_include_each_other_beyond_measure_are_refused_before_they_are_read) {
    const std::string flood = "more than 1000 million words";
    EXPECT_TRUE(contains(world_error("Include \"0\"", tree(9, 10, "Shape \"sphere\"")), flood));
    EXPECT_TRUE(contains(world_error("Include \"0\"", tree(30, 2, "")), flood));
    EXPECT_TRUE(contains(world_error("Import \"0\"", tree(9, 10, "Scale 1 1 1")), flood));
}

TEST(FileAccess, refuses_an_empty_name) {
    for (const std::string statement :
         {"Shape \"plymesh\" \"string filename\" \"\"", "Include \"\"",
          "LightSource \"point\" \"spectrum I\" \"\""}) {
        const std::string fault = world_error(statement);
        EXPECT_TRUE(contains(fault, "main.pbrt:2:") && contains(fault, "empty"))
            << statement << fault;
    }
}

}  // namespace
}  // namespace sunfleck::engine
