// Which media stand where: what is exchanged, what a camera or light without a medium takes, and
// what is warned of, by the line of the scene.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr MediumNumber kNothing = 0;
constexpr MediumNumber kTea = 1;

std::string tea() {
    return R"(MakeNamedMedium "tea" "string type" "homogeneous" "rgb sigma_s" [0 0 0]
"rgb sigma_a" [1 1 1]
)";
}

std::string in_media(const std::string& inside, const std::string& outside,
                     const std::string& body) {
    return "AttributeBegin\nMediumInterface \"" + inside + "\" \"" + outside + "\"\n" + body +
           "AttributeEnd\n";
}

std::string around(const std::string& medium) {
    return "MediumInterface \"\" \"" + medium + "\"\n";
}

std::string floor_below(double z) {
    const std::string at = " " + std::to_string(z) + "  ";
    return diffuse(".5 .5 .5") + quad("-9 -9" + at + "9 -9" + at + "9 9" + at + "-9 9" + at);
}

std::string sky() {
    return "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
}

std::string lamp_at(const std::string& place) {
    return "LightSource \"point\" \"point3 from\" [" + place + "]\n";
}

std::string from_afar() {
    return view("0 -6 3  0 0 0  0 0 1", 40, 8) + tea();
}

std::string within() {
    return view("0 0 0  1 0 0  0 0 1", 60, 8) + tea();
}

std::string lines_of(const Scene& scene) {
    std::string lines;
    for (const auto& entry : scene.warnings().entries()) lines += entry.line() + "\n";
    return lines;
}

/// "test.pbrt:7:" for the line of the scene's last statement of that kind.
std::string place_of(const std::string& text, const std::string& statement) {
    const std::size_t at = text.rfind(statement);
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<int>(at), '\n');
    return "test.pbrt:" + std::to_string(line) + ":";
}

/// Warned of once: at that place, in a line with that word. (An empty word: of nothing at all.)
void expect_warning(const std::string& text, const std::string& place, const std::string& word) {
    const std::string lines = lines_of(scene_of(text));
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), word.empty() ? 0 : 1) << lines;
    EXPECT_NE(lines.find(place), std::string::npos) << place << " in " << lines;
    EXPECT_NE(lines.find(word), std::string::npos) << lines;
}

const std::vector<std::string>& materials() {
    static const std::vector<std::string> all = {"Material \"interface\"\n",
                                                 "Material \"dielectric\" \"float eta\" 1\n",
                                                 "Material \"dielectric\" \"float eta\" 1.5\n"};
    return all;
}

/// Rays go around its edge from one medium into the other.
TEST(MediaCheck, warns_of_an_open_shape_with_different_media) {
    const std::string half_ball = "Shape \"sphere\" \"float zmax\" 0.2\n";
    const std::string disk = "Shape \"disk\" \"float radius\" 1.5\n";
    const std::string tube = "Shape \"cylinder\" \"float radius\" 0.7\n";
    const std::string bowl =
        R"(Shape "trianglemesh" "point3 P" [1 0 0  -1 0 0  0 1 0  0 -1 0  0 0 -1]
"integer indices" [4 2 0  4 1 2  4 3 1  4 0 3]
)";
    for (const std::string& material : materials())
        for (const std::string& shape : {half_ball, disk, tube, bowl})
            for (const char* reversed : {"", "ReverseOrientation\n"}) {
                const std::string text = from_afar() + sky() + floor_below(-1.5) +
                                         in_media("tea", "", material + reversed + shape);
                const std::string lines = lines_of(scene_of(text));
                const std::string place = place_of(text, "Shape");
                EXPECT_NE(lines.find(place + "1: warning: its MediumInterface"), std::string::npos)
                    << text << lines;
            }
}

TEST(MediaCheck, says_nothing_of_what_is_right) {
    const std::string ball = "Shape \"sphere\"\n";
    const std::string small = "Shape \"sphere\" \"float radius\" 0.5\n";
    const std::string lamp = "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n";
    for (const std::string& material : materials()) {
        const std::string body = in_media("tea", "", material + ball);
        for (const std::string& scene :
             {body, in_media("tea", "", material + box({-1, -1, -1}, {1, 1, 1})),
              body + in_media("", "tea", material + small),
              body + in_media("", "tea", lamp + diffuse("0 0 0") + small),
              body + in_media("", "tea", lamp_at("0 0 0"))})
            expect_warning(from_afar() + sky() + floor_below(-1.5) + scene, "", "");
        expect_warning(around("tea") + within() + sky() + body, "", "");
    }
}

/// As in most scenes: what names the fog for the camera names it for all that follows.
TEST(MediaCheck, says_nothing_of_opaque_shapes_in_fog) {
    const std::string leaf =
        "Rotate 60 1 0 0\n" + diffuse(".5 .5 .5") + "Shape \"disk\" \"float radius\" 0.8\n";
    const std::string tube = "Material \"conductor\"\nShape \"cylinder\" \"float radius\" 0.4\n";
    for (const std::string& thing : {leaf, tube})
        expect_warning(around("tea") + from_afar() + lamp_at("2 1 3") + floor_below(-1.5) + thing,
                       "", "");
}

TEST(MediaCheck, a_light_that_names_a_medium_decides_for_a_camera_that_names_none) {
    for (const std::string& material : materials()) {
        const std::string text =
            within() +
            in_media("", "tea",
                     lamp_at("0 0.5 0.2") + material +
                         "ReverseOrientation\nShape \"sphere\" \"float radius\" 2\n") +
            diffuse(".5 .5 .5") + "Shape \"sphere\" \"float radius\" 3\n";
        expect_warning(text, "test.pbrt:", "the camera");
        const Scene scene = scene_of(text);
        EXPECT_EQ(scene.media().at_camera, kTea);
        EXPECT_EQ(lines_of(scene).find("exchanged"), std::string::npos);
    }
}

TEST(MediaCheck, a_camera_that_names_a_medium_decides_for_a_light_that_names_none) {
    const std::string text =
        around("tea") + within() + around("") + lamp_at("0.3 0.5 0.2") +
        in_media("", "tea", "Material \"interface\"\nReverseOrientation\nShape \"sphere\"\n") +
        diffuse(".5 .5 .5") + "Shape \"sphere\" \"float radius\" 3\n";
    expect_warning(text, place_of(text, "LightSource"), "this light");
    EXPECT_EQ(scene_of(text).media().at_lights[0].inside, kTea);
}

TEST(MediaCheck, lights_without_a_medium_stand_in_that_of_the_shape_around_them) {
    const std::string ball = in_media("tea", "", "Material \"interface\"\nShape \"sphere\"\n");
    const std::string bulb = "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n" +
                             diffuse("0 0 0") +
                             "Shape \"sphere\" \"float radius\" 0.1\nAttributeEnd\n";
    for (const std::string& lamp : {lamp_at("0.1 0.2 0"), bulb}) {
        const std::string text = from_afar() + lamp + ball + floor_below(-1.5);
        expect_warning(text, "test.pbrt:", "this light");
        EXPECT_EQ(scene_of(text).media().at_lights[0].outside, kTea);
    }
    const std::string beside = from_afar() + lamp_at("0 3 3") + ball + floor_below(-1.5);
    expect_warning(beside, "", "");
    EXPECT_EQ(scene_of(beside).media().at_lights[0].outside, kNothing);
}

/// A scene of fog has no surface that names it.
TEST(MediaCheck, lights_and_camera_agree_where_no_surface_names_a_medium) {
    const std::string fog = around("tea") + within() + floor_below(-1);
    expect_warning(fog + lamp_at("1 1 1"), "", "");
    const std::string text = fog + around("") + lamp_at("1 1 1");
    expect_warning(text, place_of(text, "LightSource"), "this light");
    const std::string other = fog + "MakeNamedMedium \"milk\" \"string type\" \"homogeneous\"\n" +
                              around("milk") + lamp_at("1 1 1");
    EXPECT_NE(lines_of(scene_of(other)).find("other media than the one in which it stands"),
              std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
