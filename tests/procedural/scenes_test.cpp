// Every procedural scene: its files, their form, their sizes, and their bytes.

#include "procedural/scenes.h"

#include "level_faces.h"
#include "scene_parts.h"
#include "scene_reading.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <map>

namespace sunfleck::engine {
namespace {

class EveryScene : public testing::TestWithParam<ProceduralScene> {
protected:
    std::vector<SceneFile> files_ = make_scene(GetParam().name);
};

TEST_P(EveryScene, begins_with_the_file_of_its_name) {
    EXPECT_EQ(files_.at(0).name, GetParam().name + ".pbrt");
    EXPECT_FALSE(GetParam().what.empty());
    const std::string& text = files_.at(0).bytes;
    EXPECT_TRUE(text.starts_with("# Sunfleck, scene " + GetParam().name));
    EXPECT_NE(text.find("CC0 1.0"), std::string::npos);
    EXPECT_EQ(text.find('@'), std::string::npos) << "a mark was not replaced";
}

TEST_P(EveryScene, has_balanced_brackets_and_blocks) {
    int open = 0;
    int blocks = 0;
    int worlds = 0;
    for (const std::string& word : pbrt_words(files_.at(0).bytes)) {
        open += word == "[" ? 1 : 0;
        open -= word == "]" ? 1 : 0;
        blocks += word == "AttributeBegin" ? 1 : 0;
        blocks -= word == "AttributeEnd" ? 1 : 0;
        worlds += word == "WorldBegin" ? 1 : 0;
        ASSERT_TRUE(open == 0 || open == 1) << word;
        ASSERT_GE(blocks, 0);
    }
    EXPECT_EQ(open, 0);
    EXPECT_EQ(blocks, 0);
    EXPECT_EQ(worlds, 1);
}

TEST_P(EveryScene, uses_only_statements_that_pbrt_has) {
    const std::vector<std::string> known = {"Scale",
                                            "LookAt",
                                            "Camera",
                                            "Film",
                                            "PixelFilter",
                                            "Sampler",
                                            "Integrator",
                                            "WorldBegin",
                                            "LightSource",
                                            "Material",
                                            "MakeNamedMaterial",
                                            "NamedMaterial",
                                            "AreaLightSource",
                                            "MakeNamedMedium",
                                            "MediumInterface",
                                            "Texture",
                                            "Translate",
                                            "Shape",
                                            "AttributeBegin",
                                            "AttributeEnd"};
    for (const std::string& word : pbrt_words(files_.at(0).bytes)) {
        if (std::isalpha(static_cast<unsigned char>(word[0])) == 0) continue;
        EXPECT_NE(std::find(known.begin(), known.end(), word), known.end()) << word;
    }
}

TEST_P(EveryScene, names_each_file_it_brings_and_no_other) {
    const std::vector<std::string> words = pbrt_words(files_.at(0).bytes);
    for (std::size_t i = 1; i < files_.size(); ++i) {
        EXPECT_TRUE(files_[i].name.starts_with("geometry/"));
        EXPECT_EQ(std::count(words.begin(), words.end(), "\"" + files_[i].name), 1);
    }
    EXPECT_NO_THROW(scene_meshes(files_));
}

TEST_P(EveryScene, has_sound_triangles) {
    for (const Mesh& mesh : scene_meshes(files_)) {
        ASSERT_FALSE(mesh.triangles.empty());
        for (const auto& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                ASSERT_LT(t.at(i), mesh.points.size());
                ASSERT_NE(mesh.points[t.at(i)], mesh.points[t.at((i + 1) % 3)]);
            }
    }
}

TEST_P(EveryScene, is_made_alike_each_time) {
    const std::vector<SceneFile> again = make_scene(GetParam().name);
    ASSERT_EQ(again.size(), files_.size());
    for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].bytes, files_[i].bytes);
}

/// FNV-1a of all names and bytes.
std::uint64_t fingerprint(const std::vector<SceneFile>& files) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&](const std::string& text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    };
    for (const SceneFile& file : files) {
        add(file.name);
        add(file.bytes);
    }
    return hash;
}

// A change of any byte of a scene shows here: pictures made of it are then no longer comparable.
TEST_P(EveryScene, has_the_bytes_that_pictures_were_made_of) {
    const std::map<std::string, std::uint64_t> known = {
        {"cornell", 0x91ac4398ab085897},       {"cognac-0", 0x44c956006899667d},
        {"cognac-1", 0x9c0cbd6f97a14462},      {"cognac-2", 0x3d236a3728cdb121},
        {"cognac-3", 0xa9baea26be3b83a5},      {"cognac-4", 0x9928d3768ccb555a},
        {"cognac-5", 0x9c628b5743ddfa4c},      {"cognac-6", 0x8be59a0468be5182},
        {"window-room", 0x2b0f398c90f67e1b},   {"window-room-lamp", 0xa9219e7cce96512a},
        {"diamond", 0x760213fba6f7a7c3},       {"iced-tea", 0x2f798dd4365058de},
        {"cornell-door", 0xa83096d327dbb6d9},  {"two-windows", 0x7220f79a5983d984},
        {"light-shafts", 0x819c936d4f9bf9d9},  {"box", 0x3851a0aa0d639e6a},
        {"watch", 0xcfefa812fba1ee89},         {"room", 0x56caa08c700e081},
        {"statue-far", 0x26edb9a0c3b9bf6f},    {"statue-near", 0x90db2774ad7d0a1a},
        {"magnifier", 0x535e3596581fdd39},     {"useful-light", 0x6ae7e5ba14fc0e10},
        {"useless-light", 0x58b61d01cf208ab2}, {"keyhole-4", 0xcf1d1a5deef40a3b},
        {"keyhole-6", 0xf541a393bdb7b3},       {"keyhole-8", 0xe8c8a9dfa36378bf},
        {"keyhole-9", 0x90f334e92184c31d},     {"keyhole-lamp", 0xbaa7065c08d77d55},
        {"milk", 0x9c85aaae509e1827},          {"fog-lamp", 0x41a2941ff270b148},
        {"opal", 0xc04be626bbe835dc},          {"pool", 0xfa2e714193254496},
        {"smoke", 0x2ef6996e95699c4d},         {"brandy", 0xab175445f9a91b0f},
        {"wine-glass-1", 0x66fc9bad46cebef1},  {"wine-glass-2", 0xd9df0c251a841e79},
        {"wine-glass-3", 0x960584a4454d130e},  {"wine-glass-4", 0x2ca5b4f49d536ae5},
    };
    EXPECT_EQ(known.at(GetParam().name), fingerprint(files_))
        << "0x" << std::hex << fingerprint(files_);
}

TEST_P(EveryScene, has_the_number_of_triangles_it_promises) {
    std::size_t triangles = 0;
    for (const Mesh& mesh : scene_meshes(files_)) triangles += mesh.triangles.size();
    const std::map<std::string, std::size_t> promised = {
        {"cornell", 36},          {"window-room", 262},    {"window-room-lamp", 262},
        {"milk", 73986},          {"fog-lamp", 13448},     {"opal", 16484},
        {"pool", 79568},          {"smoke", 17492},        {"brandy", 193146},
        {"diamond", 112},         {"iced-tea", 13044},     {"cornell-door", 730},
        {"two-windows", 43070},   {"light-shafts", 42874}, {"box", 3466},
        {"watch", 153274},        {"room", 159714},        {"statue-far", 378638},
        {"statue-near", 378638},  {"magnifier", 72348},    {"useful-light", 64824},
        {"useless-light", 64824}, {"keyhole-4", 20},       {"keyhole-6", 20},
        {"keyhole-8", 20},        {"keyhole-9", 20},       {"keyhole-lamp", 22},
    };
    const std::string& name = GetParam().name;
    if (name.starts_with("cognac"))
        EXPECT_EQ(triangles, 16456);
    else if (name.starts_with("wine-glass"))
        EXPECT_EQ(triangles, 172290);
    else
        EXPECT_EQ(triangles, promised.at(name));
}

INSTANTIATE_TEST_SUITE_P(all, EveryScene, testing::ValuesIn(procedural_scenes()),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

/// Scenes whose bodies are closed each by itself and may end within one another.
class SolidScene : public testing::TestWithParam<const char*> {};

TEST_P(SolidScene, has_closed_glass_that_faces_out) {
    for (const Part& part : parts_of(GetParam())) {
        if (!is_glass(part)) continue;
        EXPECT_TRUE(open_edges(part.mesh).empty());
        EXPECT_GT(volume(part.mesh), 0);
    }
}

TEST_P(SolidScene, has_no_two_level_faces_in_one_place) {
    EXPECT_EQ(doubled_face(scene_meshes(make_scene(GetParam()))), "");
}

INSTANTIATE_TEST_SUITE_P(all, SolidScene,
                         testing::Values("cornell-door", "two-windows", "box", "watch", "room",
                                         "statue-far", "magnifier", "useless-light", "fog-lamp",
                                         "opal", "pool", "smoke", "keyhole-8", "keyhole-9",
                                         "keyhole-lamp"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(Scenes, are_these) {
    std::string names;
    for (const ProceduralScene& scene : procedural_scenes()) names += scene.name + ' ';
    EXPECT_EQ(names,
              "cornell cognac-0 cognac-1 cognac-2 cognac-3 cognac-4 cognac-5 cognac-6 "
              "window-room window-room-lamp brandy diamond iced-tea cornell-door two-windows "
              "light-shafts "
              "box watch room statue-far statue-near magnifier useful-light useless-light "
              "milk fog-lamp opal pool smoke wine-glass-1 "
              "wine-glass-2 wine-glass-3 wine-glass-4 keyhole-4 "
              "keyhole-6 keyhole-8 keyhole-9 keyhole-lamp ");
}

// So all can be written to one folder: none changes another that was written before.
TEST(Scenes, name_files_apart_that_differ) {
    std::map<std::string, std::string> bytes;
    for (const ProceduralScene& scene : procedural_scenes())
        for (const SceneFile& file : make_scene(scene.name)) {
            const auto [known, is_new] = bytes.try_emplace(file.name, file.bytes);
            EXPECT_TRUE(is_new || known->second == file.bytes) << scene.name << ": " << file.name;
        }
}

TEST(Scenes, an_unknown_name_is_answered_with_the_known_ones) {
    try {
        make_scene("cognac-7");
        FAIL() << "no error";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("\"cognac-7\""), std::string::npos) << message;
        for (const ProceduralScene& scene : procedural_scenes())
            EXPECT_NE(message.find(scene.name), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace sunfleck::engine
