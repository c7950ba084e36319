// Whole files: Include, Import, gzip, blocks, the folder of broken scenes, public scenes.
#include "import/pbrt/reader.h"

#include "import/pbrt/scene_text.h"
#include "support/no_access.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = SUNFLECK_SOURCE_DIR;

std::string slurp(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<fs::path> files_below(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> found;
    if (!fs::is_directory(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ending) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

TEST(Reader, splices_includes_anywhere) {
    const SceneDescription scene =
        read_text("Include \"a.pbrt\" \"float radius\" 3 Include \"sub/c.pbrt\"",
                  {{"a.pbrt", "WorldBegin Include \"sub/b.pbrt\""},
                   {"sub/b.pbrt", "# nothing\nShape \"sphere\""},
                   {"sub/c.pbrt", "Translate 1 0 0 Shape \"disk\" Include \"sub/b.pbrt\""}});
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].placed.shape).radius, 3);
    EXPECT_EQ(scene.shapes[0].where.text(), "sub/b.pbrt:2:1");
    EXPECT_EQ(Vec3d(0) * scene.shapes[2].placed.to_world, Vec3d(1, 0, 0));
    EXPECT_EQ(scene.files.size(), 3U);  // the text of main.pbrt is in memory
}

TEST(Reader, keeps_the_state_of_imports_to_themselves) {
    const MemoryFiles files = {
        {"i.pbrt",
         "Translate 1 0 0 Material \"dielectric\" Shape \"sphere\" MakeNamedMaterial "
         "\"m\" \"string type\" \"conductor\" CoordinateSystem \"s\""}};
    const SceneDescription scene = read_world(
        "Translate 0 1 0 Import \"i.pbrt\" Shape \"sphere\" NamedMaterial \"m\" Shape "
        "\"sphere\" CoordSysTransform \"s\"",
        files);
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(Vec3d(0) * scene.shapes[0].placed.to_world, Vec3d(1, 1, 0));
    EXPECT_EQ(Vec3d(0) * scene.shapes[1].placed.to_world, Vec3d(0, 1, 0));
    EXPECT_EQ(scene.materials[scene.shapes[1].material].index(), 0U);
    EXPECT_EQ(scene.materials[scene.shapes[2].material].index(), 3U);
    EXPECT_EQ(warnings_with(scene, "coordinate system"), 1);
    EXPECT_NE(world_error("Import \"i.pbrt\"", {{"i.pbrt", "AttributeBegin"}}), "");
    EXPECT_NE(world_error("AttributeBegin Import \"i.pbrt\"", {{"i.pbrt", "AttributeEnd"}}), "");
    EXPECT_NE(error_of("Import \"i.pbrt\" WorldBegin", {{"i.pbrt", ""}}), "");
}

TEST(Reader, refuses_circles_of_files) {
    EXPECT_TRUE(contains(world_error("Include \"main.pbrt\"", {{"main.pbrt", ""}}), "itself"));
    EXPECT_TRUE(
        contains(world_error("Include \"a\"", {{"a", "Include \"x/../b\""}, {"b", "Import \"a\""}}),
                 "b:1:1: \"a\" includes itself"));
    MemoryFiles chain;
    for (int i = 0; i < 200; ++i) {
        chain[fmt::format("{}", i)] = fmt::format("Include \"{}\"", i + 1);
        chain[fmt::format("i{}", i)] = fmt::format("Import \"i{}\"", i + 1);
    }
    EXPECT_TRUE(contains(world_error("Include \"0\"", chain), "more than 100 deep"));
    EXPECT_TRUE(contains(world_error("Import \"i0\"", chain), "more than 100 deep"));
}

TEST(Reader, without_file_access_reads_text_alone) {
    const std::string text = "WorldBegin Shape \"sphere\"";
    const FileAccess none = testing_support::no_access();
    EXPECT_EQ(read_pbrt_text(text, "a.pbrt", none).shapes.size(), 1U);
    EXPECT_THROW(read_pbrt_text(text + " Include \"/dev/null\"", "a.pbrt", none), Error);
}

TEST(Reader, unpacks_gzip_by_content) {
    // gzip of: WorldBegin Shape "sphere"
    const std::string packed(
        "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x0b\xcf\x2f\xca\x49\x71\x4a\x4d\xcf\xcc\x53\x08"
        "\xce\x48\x2c\x48\x55\x50\x2a\x2e\xc8\x48\x2d\x4a\x55\x02\x00\xcb\xdf\xb6\x48\x19\x00\x00"
        "\x00",
        45);
    const fs::path path = fs::path(testing::TempDir()) / "packed_scene.pbrt";
    std::ofstream(path, std::ios::binary) << packed;
    EXPECT_EQ(read_pbrt(path.string()).shapes.size(), 1U);
    std::ofstream(path, std::ios::binary) << packed.substr(0, 30);
    EXPECT_THROW(read_pbrt(path.string()), Error);
    fs::remove(path);
    EXPECT_THROW(read_pbrt(path.string()), Error);
}

TEST(Reader, warns_of_unused_parameters_with_their_place) {
    const SceneDescription scene =
        read_world("Shape \"sphere\"\n  \"float raduis\" 2\nShape \"sphere\" \"float raduis\" 3");
    ASSERT_EQ(scene.warnings.entries().size(), 1U);
    EXPECT_EQ(scene.warnings.entries()[0].line(),
              "main.pbrt:3:3: warning: unused parameter \"float raduis\" of Shape \"sphere\" is "
              "ignored (2 times)");
}

TEST(Reader, warns_of_unused_parameters_of_attribute) {
    const std::string one = "Attribute \"shape\" \"float radius\" 2 \"float raduis\" 2\n";
    const SceneDescription scene = read_world(one + "Shape \"disk\" Shape \"sphere\"");
    ASSERT_EQ(scene.warnings.entries().size(), 1U);
    EXPECT_TRUE(contains(scene.warnings.entries()[0].line(),
                         "main.pbrt:2:36: warning: parameter \"float raduis\" of Attribute is "
                         "ignored"));
}

TEST(Reader, warns_of_a_colour_space_of_the_film) {
    const std::string rest = "Film \"rgb\" WorldBegin Shape \"sphere\"";
    EXPECT_EQ(warnings_with(read_text("ColorSpace \"rec2020\" " + rest), "in linear sRGB"), 1);
    EXPECT_EQ(warnings_with(read_text(rest), "in linear sRGB"), 0);
}

/// In their frame rays would be out of range.
TEST(Reader, leaves_out_instances_of_extreme_size) {
    const auto read = [](const std::string& inner, const std::string& outer) {
        const auto scale = [](const std::string& s) { return "Scale " + s + " " + s + " " + s; };
        return read_world("ObjectBegin \"o\" " + scale(inner) +
                          " Shape \"sphere\" ObjectEnd ObjectInstance \"o\" " + scale(outer) +
                          " ObjectInstance \"o\"");
    };
    for (const char* size : {"1e-18", "1e30"}) {
        const SceneDescription scene = read("1", size);
        EXPECT_EQ(scene.instances.size(), 1U) << size;
        EXPECT_EQ(warnings_with(scene, "was left out"), 1) << size;
    }
    EXPECT_EQ(read("1e-6", "1e6").instances.size(), 2U);
    const SceneDescription far = read_world(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd Translate 1e19 0 0 ObjectInstance \"o\"");
    EXPECT_EQ(far.instances.size(), 0U);
    EXPECT_EQ(warnings_with(far, "was left out"), 1);
}

TEST(Reader, ends_its_list_of_warnings) {
    std::string text;
    for (int i = 0; i < 2000; ++i)
        text += "Shape \"sphere\" \"float x" + std::to_string(i) + "\" 1\n";
    const SceneDescription scene = read_world(text);
    EXPECT_EQ(scene.warnings.entries().size(), 501U);
    EXPECT_EQ(warnings_with(scene, "further warnings"), 1500);
}

class BrokenScene : public testing::TestWithParam<std::string> {};

TEST_P(BrokenScene, is_refused_in_one_line) {
    const fs::path folder = kSource / "tests/scenes/broken";
    const std::string path = (folder / (GetParam() + ".pbrt")).string();
    std::string message = "no error";
    try {
        read_pbrt(path);
    } catch (const Error& error) {
        message = error.what();
    }
    const std::string prefix = folder.string() + "/";
    for (std::size_t at = 0; (at = message.find(prefix)) != std::string::npos;)
        message.erase(at, prefix.size());
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_EQ(message + "\n", slurp(folder / (GetParam() + ".expected")));
}

std::vector<std::string> broken_names() {
    std::vector<std::string> names;
    for (const fs::path& path : files_below(kSource / "tests/scenes/broken", ".expected"))
        names.push_back(path.stem().string());
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, BrokenScene, testing::ValuesIn(broken_names()), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(BrokenScenes, are_at_least_forty) {
    EXPECT_GE(broken_names().size(), 40U);
    for (const fs::path& path : files_below(kSource / "tests/scenes/broken", ".pbrt")) {
        fs::path expected = path;
        const bool helper = path.stem().string().starts_with("part-");
        EXPECT_EQ(fs::exists(expected.replace_extension(".expected")), !helper) << path;
    }
}

TEST(PublicScenes, load) {
    auto paths = files_below(kSource / "../shared/data/pbrt-reference", ".pbrt");
    for (const fs::path& path : files_below(kSource / "../shared/data/pbrt", ".pbrt"))
        paths.push_back(path);
    if (paths.empty()) GTEST_SKIP() << "shared/data/pbrt is not here";
    for (const fs::path& path : paths) {
        SCOPED_TRACE(path);
        EXPECT_NO_THROW(EXPECT_FALSE(read_pbrt(path.string()).shapes.empty()));
    }
}

}  // namespace
}  // namespace sunfleck::engine
