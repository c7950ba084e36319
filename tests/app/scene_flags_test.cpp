// The flags of a scene: they add what they say, or are refused in one line.
#include "app/program.h"
#include "image/exr.h"
#include "math/vector.h"

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

/// A square without a light or a camera.
const char* const kSquare = R"({"asset":{"version":"2.0"},"scene":0,
"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4}],
"bufferViews":[{"buffer":0,"byteLength":48}],
"buffers":[{"byteLength":48,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAA"}]})";

class SceneFlags : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        write_text(path("square.gltf"), kSquare);
    }

    void write_sky(const std::string& name, int width, int height) const {
        Picture picture;
        picture.width = width;
        picture.height = height;
        for (const char* channel : {"R", "G", "B"})
            picture.add(channel).values.assign(static_cast<std::size_t>(width * height), 2);
        write_exr(path(name), picture);
    }
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(SceneFlags, give_a_scene_without_light_a_sky_but_not_one_of_pbrt) {
    const Ran square = run({"info", "square.gltf", "--lights"});
    EXPECT_EQ(square.code, 0) << square.err;
    EXPECT_TRUE(
        has(square.out + square.err, "there is no light: sky and sun are used (--sun 225,40)"))
        << square.out << square.err;
    EXPECT_TRUE(has(square.out, "light       1 sky at square.gltf")) << square.out;
    EXPECT_TRUE(has(square.out, "light       2 sun at square.gltf")) << square.out;
    write_text(path("dark.pbrt"), "WorldBegin\nShape \"sphere\"\n");
    EXPECT_TRUE(has(run({"info", "dark.pbrt"}).out, "lights      none"));
}

TEST_F(SceneFlags, add_sky_and_environment_to_any_scene) {
    write_sky("sky.exr", 8, 4);
    const Ran info = run({"info", "room.pbrt", "--lights", "--sun", "2026-06-21,12:00Z,48,16",
                          "--turbidity", "2", "--environment", "sky.exr", "--up", "z"});
    EXPECT_EQ(info.code, 0) << info.err;
    EXPECT_TRUE(has(info.out, "2 sky at --sun")) << info.out;
    EXPECT_TRUE(has(info.out, "3 sun at --sun")) << info.out;
    EXPECT_TRUE(has(info.out, "4 environment at sky.exr")) << info.out;
    const Ran with_picture = run({"info", "square.gltf", "--environment", "sky.exr"});
    EXPECT_FALSE(has(with_picture.out + with_picture.err, "there is no light"));
}

/// A lamp of 683 cd downwards and nothing upwards, one metre above the middle of a white square.
TEST_F(SceneFlags, hang_luminaires_upright_in_candela) {
    write_text(path("lamp.ies"), "TILT=NONE\n1 -1 683 2 1 1 2 0 0 0\n1 1 0\n0 89\n0\n1 1\n");
    write_text(path("lamp.pbrt"),
               "LookAt 0 0 2  0 0 0  0 1 0\nFilm \"rgb\" \"integer xresolution\" 3 \"integer "
               "yresolution\" 3\nCamera \"perspective\" \"float fov\" 0.1\nWorldBegin\n"
               "LightSource \"point\" \"point3 from\" [0 0 1]\nMaterial \"diffuse\" \"rgb "
               "reflectance\" [1 1 1]\nShape \"bilinearmesh\" \"point3 P\" [-1 -1 0 1 -1 0 -1 1 0 "
               "1 1 0]\n");
    const Ran ran = run({"render", "lamp.pbrt", "--ies", "1=lamp.ies", "-o", "x.exr",
                         "--integrator", "path", "--passes", "16"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_NEAR(read_exr(path("x.exr")).find("G")->values[4], 1 / kPi, 0.002);
    const Ran other = run({"info", "room.pbrt", "--ies", "1=lamp.ies"});
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(has(other.err, "no point and no spot")) << other.err;
}

/// The same picture as of a scene that names the medium itself, but for the last bits of its
/// curves.
TEST_F(SceneFlags, fill_the_air_with_fog) {
    const std::string head =
        "LookAt 0 -4 0  0 0 0  0 0 1\nFilm \"rgb\" \"integer xresolution\" 6 \"integer "
        "yresolution\" 6\n";
    const std::string rest =
        "Camera \"perspective\" \"float fov\" 50\nWorldBegin\nLightSource \"point\" \"point3 "
        "from\" [0 -2 2]\nShape \"sphere\"\n";
    write_text(path("clear.pbrt"), head + rest);
    write_text(path("foggy.pbrt"),
               head +
                   "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"spectrum "
                   "sigma_s\" [300 0.1875 900 0.1875] \"spectrum sigma_a\" [300 0.0625 900 "
                   "0.0625] \"float g\" 0.5\nMediumInterface \"\" \"fog\"\n" +
                   rest);
    const auto values = [&](const Words& words) {
        const Ran ran = run(testing_support::operator+(
            {"render", "-o", "x.exr", "--passes", "2", "--photons-per-pass", "500"}, words));
        EXPECT_EQ(ran.code, 0) << ran.err;
        return read_exr(path("x.exr")).find("G")->values;
    };
    const auto foggy = values({"foggy.pbrt"});
    const auto filled = values({"clear.pbrt", "--fog", "4,0.75,0.5"});
    const auto clear = values({"clear.pbrt"});
    for (std::size_t i = 0; i < foggy.size(); ++i)
        EXPECT_NEAR(filled.at(i) / foggy.at(i), 1, 1e-4) << i;
    EXPECT_EQ(clear.at(0), 0);
    EXPECT_GT(foggy.at(0), 0);
    // A sky shines through fog that ends.
    EXPECT_GT(values({"clear.pbrt", "--sun", "225,40", "--fog", "4"}).at(0), 100 * foggy.at(0));
}

TEST_F(SceneFlags, that_mean_nothing_are_refused) {
    write_sky("wide.exr", 9, 4);
    struct Row {
        Words words;
        const char* why;
    };
    const std::vector<Row> rows = {
        {{"room.pbrt", "--camera", "main"},
         "--camera: has no meaning for a scene file of this kind"},
        {{"square.gltf", "--up", "z"}, "--up: has no meaning for a scene file of this kind"},
        {{"room.pbrt", "--turbidity", "2"}, "--turbidity: has a meaning for a sky alone"},
        {{"room.pbrt", "--north", "2"}, "--north: has a meaning for a sky or an environment alone"},
        {{"room.pbrt", "--environment-scale", "2"}, "add --environment"},
        {{"room.pbrt", "--environment", "wide.exr"}, "9 x 4 pixels"},
        {{"room.pbrt", "--environment", "none.exr"}, "none.exr"},
        {{"room.pbrt", "--sun", "1,2", "--sun", "1,2"}, "--sun: is given twice"},
        {{"room.pbrt", "--sun", "1,2", "--turbidity", "0.5"}, "--turbidity"},
        {{"room.pbrt", "--fog", "4,0.5"}, "--fog: \"4,0.5\" is no MEAN_FREE_PATH[,ALBEDO,G]"},
        {{"room.pbrt", "--fog", "0"}, "--fog"},
        {{"room.pbrt", "--ies", "lamp.ies"}, "--ies: \"lamp.ies\" is no LIGHT=FILE"},
        {{"room.pbrt", "--ies", "7=lamp.ies"}, "--ies: the scene has no light \"7\""},
        {{"square.gltf", "--glass", "hollow"}, "use auto or solid or thin"}};
    for (const Row& row : rows) {
        const Ran ran = run(testing_support::operator+({"info"}, row.words));
        EXPECT_EQ(ran.code, 2) << row.why;
        EXPECT_TRUE(has(ran.err, row.why)) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
}

TEST_F(SceneFlags, are_a_part_of_the_scene_that_a_render_goes_on_with) {
    const Words first{"--sun", "10,30", "-o", "x.exr", "--passes", "1", "--checkpoint", "c"};
    EXPECT_EQ(render(first).code, 0);
    const Words other{"--sun", "20,30", "-o", "x.exr", "--passes", "2", "--resume", "c"};
    const Ran ran = render(other);
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(has(ran.err, "the flags of the scene")) << ran.err;
    const Words same{"--sun", "10,30", "-o", "x.exr", "--passes", "2", "--resume", "c"};
    EXPECT_EQ(render(same).code, 0);
}

TEST_F(SceneFlags, in_physical_units_have_an_exposure_of_their_own_that_is_told) {
    const Words words{
        "render", "square.gltf",        "-o",  "x.png", "--passes", "1", "--resolution",
        "16x9",   "--photons-per-pass", "1000"};
    const Ran found = run(words);
    EXPECT_EQ(found.code, 0) << found.err;
    const std::size_t place = found.err.find("exposure of the .png: -");
    ASSERT_NE(place, std::string::npos) << found.err;
    const std::string bytes = read_text(path("x.png"));
    const std::size_t begin = found.err.find("--exposure ", place) + 11;
    const std::string stops = found.err.substr(begin, found.err.find(')', begin) - begin);
    const Ran fixed = run(testing_support::operator+(words, {"--exposure", stops}));
    EXPECT_FALSE(has(fixed.err, "exposure of the .png")) << fixed.err;
    EXPECT_EQ(read_text(path("x.png")), bytes) << "the stops that were told";
    const Ran room = render({"-o", "y.png", "--passes", "1"});
    EXPECT_FALSE(has(room.err, "exposure of the .png")) << room.err;
}

}  // namespace
}  // namespace sunfleck::engine
