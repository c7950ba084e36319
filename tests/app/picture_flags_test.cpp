// The flags of picture files, as render, merge and relight have them alike.
#include "app/program.h"
#include "image/exr.h"
#include "image/png.h"

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::operator+;

class PictureFlags : public ProgramTest {
protected:
    void expect_picture_refused(const Words& words, const std::string& text) const {
        const std::string before = names();
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 2) << text;
        EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_EQ(names(), before);
    }
    /// Writes x.film and x.exr, with a light group and an AOV.
    void make_film() const {
        ASSERT_EQ(render({"--passes", "1", "--quiet", "-o", "x.film", "-o", "x.exr", "--aovs",
                          "depth", "--light-group", "all=1"})
                      .code,
                  0);
    }
};

/// Each flag changes the file that it is for, in the same way from each command.
TEST_F(PictureFlags, do_the_same_in_every_command) {
    struct Row {
        Words flags;
        std::string ending;
    };
    const std::vector<Row> rows = {
        {{"--tone", "filmic"}, ".png"},
        {{"--tone", "aces"}, ".jpg"},
        {{"--tone", "agx"}, ".png"},
        {{"--white-balance", "3200"}, ".png"},
        {{"--glare", "0.2"}, ".png"},
        {{"--vignette", "2"}, ".jpeg"},
        {{"--png-bits", "16"}, ".png"},
        {{"--jpeg-quality", "40"}, ".jpg"},
        {{"--exr-compression", "piz"}, ".exr"},
        {{"--exr-half", "depth"}, ".exr"},
        {{"--exr-parts", "layers"}, ".exr"},
    };
    make_film();
    for (const Row& row : rows) {
        const std::string plain = "plain" + row.ending;
        const std::string merged = "merged" + row.ending;
        const std::string again = "relit" + row.ending;
        ASSERT_EQ(run({"merge", "x.film", "-o", plain}).code, 0);
        const Ran ran = run(Words{"merge", "x.film", "-o", merged} + row.flags);
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_NE(read_text(path(merged)), read_text(path(plain))) << row.flags[0];
        if (row.ending == ".exr") continue;  // a relit one has no error bars
        const Ran relit = run(Words{"relight", "x.exr", "all=1", "-o", again} + row.flags);
        ASSERT_EQ(relit.code, 0) << relit.err;
        EXPECT_EQ(read_text(path(again)), read_text(path(merged))) << row.flags[0];
    }
}

TEST_F(PictureFlags, of_a_render_are_those_of_a_merge) {
    const Words look{"--tone",      "agx",    "--png-bits", "16",
                     "--exr-parts", "layers", "--exr-half", "all"};
    ASSERT_EQ(
        render(Words{"--passes", "2", "--quiet", "-o", "x.film", "-o", "a.png", "-o", "a.exr"} +
               look)
            .code,
        0);
    ASSERT_EQ(run(Words{"merge", "x.film", "-o", "b.png", "-o", "b.exr"} + look).code, 0);
    EXPECT_EQ(read_text(path("a.png")), read_text(path("b.png")));
    EXPECT_EQ(read_text(path("a.exr")), read_text(path("b.exr")));
    EXPECT_EQ(read_png(path("a.png")).bits, 16);
}

TEST_F(PictureFlags, without_a_file_that_they_are_for_are_refused) {
    const std::string mend = "; leave it out, or add -o FILE";
    const auto refused = [&](const std::string& flag, const std::string& value,
                             const std::string& output, const std::string& text) {
        for (const Words& command : {Words{"render", "room.pbrt"}, Words{"merge", "x.film"},
                                     Words{"relight", "x.exr", "a=1"}})
            expect_picture_refused(command + Words{"-o", output, flag, value}, flag + ": " + text);
    };
    refused("--tone", "agx", "y.exr", "no output is a .png or .jpg or .jpeg" + mend + ".png");
    refused("--glare", "0.1", "y.exr", "no output is a .png or .jpg or .jpeg" + mend + ".png");
    refused("--png-bits", "16", "y.jpg", "no output is a .png" + mend + ".png");
    refused("--jpeg-quality", "9", "y.png", "no output is a .jpg or .jpeg" + mend + ".jpg");
    refused("--exr-half", "all", "y.png", "no output is a .exr" + mend + ".exr");
    expect_picture_refused({"render", "room.pbrt", "--tone", "agx"}, "no output is a .png");
}

TEST_F(PictureFlags, have_values_with_a_range) {
    const auto refused = [&](const std::string& flag, const std::string& value,
                             const std::string& text) {
        expect_picture_refused({"merge", "x.film", "-o", "y.png", "-o", "y.exr", flag, value},
                               flag + ": " + text);
    };
    refused("--tone", "reinhard", "does not take \"reinhard\"; use none or filmic or aces or agx");
    refused("--white-balance", "900", "\"900\" is no number from 1000 to 25000");
    refused("--glare", "1.5", "\"1.5\" is no number from 0 to 1");
    refused("--vignette", "-1", "\"-1\" is no number from 0 to 20");
    refused("--png-bits", "12", "does not take \"12\"; use 8 or 16");
    refused("--exr-half", ",", "names no layer");
}

/// Before the render where that can be known.
TEST_F(PictureFlags, name_layers_that_there_are) {
    const std::string text = "--exr-half: the picture has no layer \"depht\"; use all, or some of ";
    expect_picture_refused(
        {"render", "room.pbrt", "-o", "y.exr", "--aovs", "depth", "--exr-half", "depht"},
        text + "picture, error, bias, depth");
    make_film();
    expect_picture_refused({"merge", "x.film", "-o", "y.exr", "--exr-half", "depht"}, text);
    expect_picture_refused({"relight", "x.exr", "all=1", "-o", "y.exr", "--exr-half", "depht"},
                           text);
}

TEST_F(PictureFlags, an_exr_tells_what_made_it) {
    ASSERT_EQ(render({"--passes", "2", "--seed", "7", "--quiet", "-o", "x.exr"}).code, 0);
    const auto texts = read_exr(path("x.exr")).metadata;
    EXPECT_EQ(texts.at("software"), "Sunfleck " SUNFLECK_VERSION);
    EXPECT_EQ(texts.at("passes"), "2");
    EXPECT_EQ(texts.at("seed"), "7");
    EXPECT_EQ(texts.at("scene_hash").size(), 16U);
    EXPECT_NE(texts.at("settings").find("integrator=sppm\n"), std::string::npos);
    EXPECT_GT(std::stoul(texts.at("photon_paths")), 0U);
    EXPECT_FALSE(texts.contains("capDate"));
}

/// A square screen on 16 x 12 pixels: each is three quarters as wide as high.
TEST_F(PictureFlags, an_exr_tells_the_shape_of_pixels) {
    std::string scene = room_text("0.6");
    const std::string fov = "\"float fov\" 70";
    scene.replace(scene.find(fov), fov.size(), fov + " \"float screenwindow\" [-1 1 -1 1]");
    testing_support::write_text(path("wide.pbrt"), scene);
    ASSERT_EQ(run({"render", "wide.pbrt", "--photons-per-pass", "2000", "--passes", "1", "--quiet",
                   "-o", "x.exr", "-o", "x.film"})
                  .code,
              0);
    EXPECT_EQ(read_exr(path("x.exr")).pixel_aspect, 0.75F);
    ASSERT_EQ(run({"merge", "x.film", "-o", "y.exr"}).code, 0);
    EXPECT_EQ(read_text(path("y.exr")), read_text(path("x.exr")));
    ASSERT_EQ(render({"--passes", "1", "--quiet", "-o", "z.exr"}).code, 0);
    EXPECT_EQ(read_exr(path("z.exr")).pixel_aspect, 1);
}

TEST_F(PictureFlags, a_date_that_cannot_be_is_refused_before_the_render) {
    ::setenv("SOURCE_DATE_EPOCH", "now", 1);
    const Ran ran = render({"--passes", "1", "-o", "x.exr", "--quiet"});
    ::unsetenv("SOURCE_DATE_EPOCH");
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err,
              "SOURCE_DATE_EPOCH: \"now\" is no number of seconds since 1970; set it to such a "
              "number, or unset it\n");
    EXPECT_EQ(names(), "");
}

TEST_F(PictureFlags, a_file_in_parts_is_read_by_the_other_commands) {
    ASSERT_EQ(render({"--passes", "1", "--quiet", "-o", "one.exr", "-o", "x.film", "--light-group",
                      "all=1"})
                  .code,
              0);
    ASSERT_EQ(run({"merge", "x.film", "-o", "parts.exr", "--exr-parts", "layers"}).code, 0);
    EXPECT_EQ(read_exr(path("parts.exr")), read_exr(path("one.exr")));
    EXPECT_EQ(run({"relight", "parts.exr", "all=0.5", "-o", "dim.exr"}).code, 0);
    EXPECT_EQ(run({"compare", "one.exr", "parts.exr", "--json", "c.json"}).code, 0);
}

}  // namespace
}  // namespace sunfleck::engine
