// Mattes as another program reads them, against masks made another way; and what is refused.
#include "app/program.h"
#include "image/exr.h"

#include <cstdlib>

namespace sunfleck::engine {
namespace {

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;
using testing_support::operator+;

/// Three things before a background: a ball by an instance, a floor, a pane with holes.
struct Things {
    std::string begin;  // of a scene, up to its lights
    std::string ball;
    std::string floor;
    std::string pane;
};

Things things() {
    return {.begin = R"(LookAt 0 1.5 -6  0 .6 0  0 1 0
Camera "perspective" "float fov" 40 "float lensradius" .4 "float focaldistance" 4
Film "rgb" "integer xresolution" 24 "integer yresolution" 20
WorldBegin
)",
            .ball = R"(Shape "sphere" "float radius" 1
)",
            .floor = R"(Shape "bilinearmesh" "point3 P" [-2 -1 -2  2 -1 -2  -2 -1 2  2 -1 2]
)",
            .pane = R"(Shape "bilinearmesh" "point3 P" [.2 -1 -2  1.5 -1 -2  .2 1.2 -2  1.5 1.2 -2]
"float alpha" .5
)"};
}

std::string lit_scene() {
    const Things t = things();
    return t.begin +
           "LightSource \"infinite\"\nMakeNamedMaterial \"blue\" \"string type\" "
           "\"diffuse\" \"rgb reflectance\" [.1 .1 .8]\n"
           "ObjectBegin \"ball\"\nNamedMaterial \"blue\"\n" +
           t.ball + "ObjectEnd\nObjectInstance \"ball\"\nObjectBegin \"floor\"\n" + t.floor +
           "ObjectEnd\nObjectInstance \"floor\"\nObjectBegin \"pane\"\n" + t.pane +
           "ObjectEnd\nObjectInstance \"pane\"\n";
}

/// A scene where one thing alone shines, white, and nothing reflects light.
std::string mask_scene(const std::string& of) {
    const Things t = things();
    const auto thing = [&](const std::string& name, const std::string& shape) {
        const std::string light =
            "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\n";
        return "AttributeBegin\n" + (name == of ? light : "") + shape + "AttributeEnd\n";
    };
    return t.begin + "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + thing("ball", t.ball) +
           thing("floor", t.floor) + thing("pane", t.pane);
}

class Cryptomatte : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        write_text(path("lit.pbrt"), lit_scene());
    }
    Ran render_lit(const Words& words) const {
        return run(
            Words{"render", "lit.pbrt", "--passes", "1", "--photons-per-pass", "2000", "--quiet"} +
            words);
    }
    void expect_matte_refused(const Words& words, const std::string& text) const {
        const Ran ran = render_lit(words);
        EXPECT_EQ(ran.code, 2) << text;
        EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
};

/// The mask has 1024 camera paths of a pixel, the matte as many rays. Measured: mean differences of
/// .0026, .0029 and .0042, most of it the chance of the pane's alpha; with another pixel filter
/// (box) .0052, .0058 and .0078, without the lens .0073, .0097 and .0047.
TEST_F(Cryptomatte, of_each_object_is_what_shines_where_it_alone_does) {
    const Words python{"python3", "-B", SUNFLECK_SOURCE_DIR "/tests/app/read_matte.py"};
    ASSERT_EQ(render_lit({"-o", "lit.exr", "--cryptomatte", "object,material",
                          "--cryptomatte-samples", "1024"})
                  .code,
              0);
    struct Row {
        std::string name;
        double most;
    };
    for (const auto& [name, most] : {Row{"ball", 0.004}, Row{"floor", 0.004}, Row{"pane", 0.006}}) {
        write_text(path("mask.pbrt"), mask_scene(name));
        ASSERT_EQ(run({"render", "mask.pbrt", "--integrator", "path", "--max-depth", "1",
                       "--passes", "1024", "--quiet", "-o", "mask.exr"})
                      .code,
                  0);
        const Ran ran =
            Process(path(""), python + Words{"lit.exr", "CryptoObject", name, "mask.exr"},
                    "/usr/bin/env")
                .wait();
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_LT(std::stod(ran.out), most) << name;
    }
}

TEST_F(Cryptomatte, files_are_the_same_for_any_threads_passes_and_samplers) {
    const Words matte{"--cryptomatte", "object,material"};
    ASSERT_EQ(render_lit(matte + Words{"-o", "a.exr", "--nthreads", "1"}).code, 0);
    ASSERT_EQ(render_lit(matte + Words{"-o", "b.exr", "--nthreads", "2"}).code, 0);
    ASSERT_EQ(run(Words{"render", "lit.pbrt", "-o", "c.exr", "--integrator", "path", "--passes",
                        "3", "--seed", "5", "--quiet"} +
                  matte)
                  .code,
              0);
    EXPECT_EQ(read_text(path("a.exr")), read_text(path("b.exr")));
    const Picture one = read_exr(path("a.exr"));
    const Picture other = read_exr(path("c.exr"));
    std::size_t compared = 0;
    for (const Channel& channel : one.channels) {
        if (!channel.name.starts_with("Crypto")) continue;
        ASSERT_NE(other.find(channel.name), nullptr) << channel.name;
        EXPECT_EQ(other.find(channel.name)->values, channel.values) << channel.name;
        ++compared;
    }
    EXPECT_EQ(compared, 24U);
}

/// A render that has ended gets its mattes from its checkpoint.
TEST_F(Cryptomatte, of_a_resumed_render_are_those_of_a_whole_one) {
    ASSERT_EQ(render_lit({"-o", "a.exr", "--checkpoint", "a.ckpt"}).code, 0);
    ASSERT_EQ(
        render_lit({"-o", "b.exr", "--resume", "a.ckpt", "--cryptomatte", "object,material"}).code,
        0);
    ASSERT_EQ(render_lit({"-o", "c.exr", "--cryptomatte", "object,material"}).code, 0);
    EXPECT_EQ(read_text(path("b.exr")), read_text(path("c.exr")));
}

TEST_F(Cryptomatte, stay_when_lamps_are_dimmed) {
    ASSERT_EQ(render_lit({"-o", "a.exr", "--cryptomatte", "object", "--light-group", "all=1"}).code,
              0);
    ASSERT_EQ(run({"relight", "a.exr", "all=0.5", "-o", "dim.exr", "--exr-half", "all"}).code, 0);
    const Picture before = read_exr(path("a.exr"));
    const Picture after = read_exr(path("dim.exr"));
    for (const char* name : {"CryptoObject00.R", "CryptoObject00.G", "CryptoObject02.A"}) {
        ASSERT_NE(after.find(name), nullptr) << name;
        EXPECT_EQ(after.find(name)->values, before.find(name)->values) << name;
    }
    EXPECT_EQ(after.metadata.at("cryptomatte/3ae39a5/manifest"),
              before.metadata.at("cryptomatte/3ae39a5/manifest"));
    const Ran lossy =
        run({"relight", "a.exr", "all=0.5", "-o", "small.exr", "--exr-compression", "dwaa"});
    EXPECT_EQ(lossy.code, 2);
    EXPECT_NE(lossy.err.find("would change the IDs of mattes"), std::string::npos) << lossy.err;
}

TEST_F(Cryptomatte, what_no_output_holds_is_refused) {
    expect_matte_refused({"-o", "a.png", "--cryptomatte", "object"}, "no output is an .exr");
    expect_matte_refused({"-o", "a.exr", "--cryptomatte", "objects"},
                         "there is no matte \"objects\"; use object or material");
    expect_matte_refused({"-o", "a.exr", "--cryptomatte", ","}, "there is no matte \"\"");
    expect_matte_refused({"-o", "a.exr", "--cryptomatte", "object", "--cryptomatte-samples", "100"},
                         "100 is no power of two; use 64 or 128");
    expect_matte_refused({"-o", "a.exr", "--cryptomatte", "object", "--exr-compression", "dwab"},
                         "use zip or piz");
    expect_matte_refused({"-o", "a.exr", "--cryptomatte-samples", "64"}, "--cryptomatte");
}

}  // namespace
}  // namespace sunfleck::engine
