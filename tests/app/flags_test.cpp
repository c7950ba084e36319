// Each flag of `sunfleck render` has its effect; what is not offered is refused in one line.
#include "app/program.h"
#include "image/exr.h"

#include <numeric>

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

double mean(const Picture& picture, const std::string& channel) {
    const auto& values = picture.find(channel)->values;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

class Flags : public ProgramTest {
protected:
    /// The picture and the statistics of a render with these words.
    struct Rendered {
        std::string bytes;
        Picture picture;
        nlohmann::json stats;
    };
    Rendered rendered(const Words& words) const {
        const Words passes{"--passes", "2"};
        const Words fixed{"-o", "x.exr", "--stats", "x.json", "--nthreads", "1"};
        const bool has_limit = std::find_if(words.begin(), words.end(), [](const auto& w) {
                                   return w == "--pass-range" || w == "--spp";
                               }) != words.end();
        const Ran ran = render(fixed + (has_limit ? words : passes + words));
        EXPECT_EQ(ran.code, 0) << ran.err;
        return {read_text(path("x.exr")), read_exr(path("x.exr")), json("x.json")};
    }
};

TEST_F(Flags, change_the_picture_and_are_recorded) {
    const Rendered plain = rendered({});
    const auto setting = [](const Rendered& r, const char* name) {
        return r.stats["settings"][name].get<std::string>();
    };
    struct Row {
        Words words;
        const char* name;
        const char* value;
    };
    const std::vector<Row> rows = {
        {{"--integrator", "path"}, "integrator", "path"},
        {{"--photon-sampler", "random"}, "photon_sampler", "random"},
        {{"--direct", "photons"}, "direct", "photons"},
        {{"--photons-per-pass", "1000"}, "photons_per_pass", "1000"},
        {{"--radius-pixels", "3"}, "radius_pixels", "3"},
        {{"--radius", "0.25"}, "radius", "0.25"},
        {{"--indirect-radius", "3"}, "indirect_radius", "3"},
        {{"--alpha", "0.1"}, "alpha", "0.1"},
        {{"--max-depth", "2"}, "max_depth", "2"},
    };
    for (const Row& row : rows) {
        const Rendered other = rendered(row.words);
        EXPECT_EQ(setting(other, row.name), row.value);
        EXPECT_NE(setting(plain, row.name), row.value);
        EXPECT_TRUE(other.picture.channels != plain.picture.channels) << row.name;
    }
}

/// Rough metal shows it; without one the picture stays, and film files of both do not mix.
TEST_F(Flags, energy_compensation) {
    const Words on{"--energy-compensation", "on"};
    const Rendered plain = rendered({});
    EXPECT_FALSE(plain.stats["settings"].contains("energy_compensation"));
    EXPECT_EQ(rendered({"--energy-compensation", "off"}).bytes, plain.bytes);
    const Rendered kept = rendered(on);
    EXPECT_EQ(kept.stats["settings"]["energy_compensation"], "on");
    EXPECT_EQ(kept.picture.find("G")->values, plain.picture.find("G")->values);

    ASSERT_EQ(render({"-o", "a.film", "--pass-range", "0:1"}).code, 0);
    ASSERT_EQ(render(on + Words{"-o", "b.film", "--pass-range", "1:2"}).code, 0);
    const Ran merged = run({"merge", "a.film", "b.film", "-o", "x.exr"});
    EXPECT_EQ(merged.code, 2);
    EXPECT_NE(merged.err.find("energy_compensation"), std::string::npos) << merged.err;

    const std::string text = room_text("0.6");
    write_text(path("room.pbrt"), text +
                                      "Material \"conductor\" \"float roughness\" .5 "
                                      "Shape \"sphere\" \"float radius\" .7\n");
    const Rendered lost = rendered({});
    const Rendered given_back = rendered(on);
    EXPECT_GT(mean(given_back.picture, "R"), 1.01 * mean(lost.picture, "R"));
}

TEST_F(Flags, seed) {
    const Rendered plain = rendered({});
    EXPECT_EQ(plain.stats["seed"], 0);
    const Rendered largest = rendered({"--seed", "18446744073709551615"});
    EXPECT_EQ(largest.stats["seed"].get<std::uint64_t>(), 18446744073709551615U);
    EXPECT_TRUE(largest.picture.channels != plain.picture.channels);
    EXPECT_EQ(rendered({"--seed", "0"}).bytes, plain.bytes);
}

TEST_F(Flags, passes_and_their_other_name) {
    EXPECT_EQ(rendered({}).stats["passes"], 2);
    EXPECT_EQ(rendered({"--spp", "3"}).stats["passes"], 3);
}

TEST_F(Flags, pass_range) {
    const Rendered range = rendered({"--pass-range", "5:8"});
    EXPECT_EQ(range.stats["passes"], 3);
    EXPECT_EQ(range.stats["pass_ranges"], nlohmann::json::parse("[[5,8]]"));
    EXPECT_TRUE(range.picture.channels != rendered({"--pass-range", "0:3"}).picture.channels);
}

TEST_F(Flags, resolution) {
    const Rendered other = rendered({"--resolution", "20x8"});
    EXPECT_EQ(other.picture.width, 20);
    EXPECT_EQ(other.picture.height, 8);
    EXPECT_EQ(other.stats["resolution"], nlohmann::json::parse("[20,8]"));
}

/// Random numbers go by the pixel's place in the window: the same light, not the same bytes.
TEST_F(Flags, crop_shows_the_same_part) {
    const Words passes{"--pass-range", "0:64", "--photons-per-pass", "20000", "--aovs", "depth"};
    const Rendered whole = rendered(passes);
    const Rendered part = rendered(passes + Words{"--crop", "5,8,7,10"});
    ASSERT_EQ(part.picture.width, 3);
    ASSERT_EQ(part.picture.height, 3);
    // Light through the ball is noisy: its mean here has a standard error of some 6%.
    for (const auto& [channel, tolerance] : {std::pair("G", 0.2), std::pair("depth.Z", 0.05)}) {
        double expected = 0;
        for (std::size_t y = 7; y < 10; ++y)
            for (std::size_t x = 5; x < 8; ++x)
                expected += whole.picture.find(channel)->values[16 * y + x] / 9;
        EXPECT_NEAR(mean(part.picture, channel), expected, tolerance * expected) << channel;
    }
    // The test can tell: this part, the ball, is nearer than the rest.
    EXPECT_GT(mean(whole.picture, "depth.Z"), 1.3 * mean(part.picture, "depth.Z"));
}

TEST_F(Flags, aovs) {
    EXPECT_EQ(rendered({}).picture.channels.size(), 4U);  // the error, too
    const Picture picture = rendered({"--aovs", "direct,caustic,indirect,emission,depth"}).picture;
    for (const char* name : {"R", "direct.R", "caustic.G", "indirect.B", "emission.R", "depth.Z"})
        EXPECT_NE(picture.find(name), nullptr) << name;
    EXPECT_EQ(picture.find("albedo.R"), nullptr);
    for (const char* c : {"R", "G", "B"})
        EXPECT_NEAR(mean(picture, c),
                    mean(picture, std::string("direct.") + c) +
                        mean(picture, std::string("caustic.") + c) +
                        mean(picture, std::string("indirect.") + c) +
                        mean(picture, std::string("emission.") + c),
                    1e-5);
}

TEST_F(Flags, exposure_changes_the_png_alone) {
    const Words base{"-o", "x.exr", "-o", "x.png", "--passes", "1", "--exposure"};
    ASSERT_EQ(render(base + Words{"0"}).code, 0);
    const std::string exr = read_text(path("x.exr"));
    const std::string png = read_text(path("x.png"));
    ASSERT_EQ(render(base + Words{"-2.5"}).code, 0);
    EXPECT_EQ(read_text(path("x.exr")), exr);
    EXPECT_NE(read_text(path("x.png")), png);
}

TEST_F(Flags, threads_and_instruction_set_are_recorded) {
    ASSERT_EQ(render({"-o", "x.exr", "--passes", "1", "--nthreads", "3", "--isa", "native",
                      "--stats", "x.json"})
                  .code,
              0);
    EXPECT_EQ(json("x.json")["threads"], 3);
    EXPECT_EQ(json("x.json")["isa"], "native");
}

TEST_F(Flags, log_levels) {
    std::string text = room_text("0.6");
    text.erase(text.find("Integrator"), text.find("WorldBegin") - text.find("Integrator"));
    text.erase(text.find("AreaLightSource"),
               text.find('\n', text.find("AreaLightSource")) - text.find("AreaLightSource"));
    write_text(path("room.pbrt"), text);
    const Words base{"-o", "x.exr", "--passes", "1"};
    const std::string depth = "using 64 (--max-depth)";
    const std::string no_light = "no light";
    const auto says = [&](const Words& words) {
        const Ran ran = render(base + words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.out, "");
        return std::pair(ran.err.find(depth) != std::string::npos,
                         ran.err.find(no_light) != std::string::npos);
    };
    EXPECT_EQ(says({}), std::pair(true, true));
    EXPECT_EQ(says({"--log-level", "info"}), std::pair(true, true));
    EXPECT_EQ(says({"--log-level", "warning"}), std::pair(false, true));
    EXPECT_EQ(says({"--log-level", "quiet"}), std::pair(false, false));
    EXPECT_EQ(says({"--quiet"}), std::pair(false, false));
}

TEST_F(Flags, output_may_stand_before_the_scene) {
    const Ran ran = run({"render", "--passes", "1", "-o", "a.exr", "--photons-per-pass", "100",
                         "-o", "b.png", "-o", "c.film", "room.pbrt"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(names(), "a.exr b.png c.film");
}

TEST_F(Flags, without_output_the_scene_names_the_file) {
    ASSERT_EQ(render({"--passes", "1"}).code, 0);
    EXPECT_EQ(names(), "named.exr");
}

TEST_F(Flags, bad_values_are_refused_in_one_line) {
    const std::vector<Words> bad = {
        {"--photon-sampler", "none"},
        {"--integrator", "vcm"},
        {"--direct", "none"},
        {"--energy-compensation", "yes"},
        {"--camera", "front"},
        {"--checkpoint", ""},
        {"--checkpoint", "no/x"},
        {"--checkpoint", "room.pbrt"},
        {"--every", "3s"},
        {"--every", "soon", "--checkpoint", "x"},
        {"--resume", ""},
        {"--resume", "x"},
        {"--log-level", "loud"},
        {"--quiet", "--log-level", "info"},
        {"--passes", "0"},
        {"--passes", "-1"},
        {"--passes", "4294967297"},
        {"--passes"},
        {"--passes", "3", "--pass-range", "0:2"},
        {"--pass-range", "4:4"},
        {"--pass-range", "-1:4"},
        {"--pass-range", "1:2x"},
        {"--time", "0"},
        {"--cpu-time", "0"},
        {"--time", "nan"},
        {"--time", "5x"},
        {"--target-error", "0"},
        {"--target-error", "150%"},
        {"--seed", "-1"},
        {"--seed", "18446744073709551616"},
        {"--seed", "1", "--seed", "2"},
        {"--nthreads", "0"},
        {"--nthreads", "1.5"},
        {"--resolution", "0x5"},
        {"--resolution", "70000x1"},
        {"--resolution", "8x8x8"},
        {"--crop", "1,2"},
        {"--crop", "5,5,0,2"},
        {"--crop", "16,20,0,2"},
        {"--crop", "10,17,0,2"},
        {"--crop", "-1,4,0,2"},
        {"--cropwindow", "0,1,0"},
        {"--cropwindow", "0,1,0,1,1"},
        {"--cropwindow", "0,1.5,0,1"},
        {"--cropwindow", "-0.1,1,0,1"},
        {"--cropwindow", "0.5,0.5,0,1"},
        {"--cropwindow", "0,1,0,1", "--crop", "0,4,0,4"},
        {"--radius", "nan"},
        {"--radius", "0"},
        {"--radius", "inf"},
        {"--radius", "1", "--radius-pixels", "3"},
        {"--radius-pixels", "nan"},
        {"--radius-pixels", "-2"},
        {"--indirect-radius", "0.9"},
        {"--indirect-radius", "101"},
        {"--alpha", "nan"},
        {"--alpha", "1"},
        {"--max-depth", "0"},
        {"--aovs", "colour"},
        {"--exposure", "nan"},
        {"--isa", "sse"},
        {"--integrator", "path", "--aovs", "depth"},
        {"--integrator", "path", "--photon-sampler", "random"},
        {"--integrator", "path", "--mode", "paper"},
        {"--integrator", "path", "--radius", "1"},
        {"--integrator", "path", "--indirect-radius", "2"},
        {"--no-such-flag"},
        {"another.pbrt"},
    };
    for (const Words& words : bad) {
        const Ran ran = render(Words{"-o", "x.exr", "--stats", "x.json"} + words);
        std::string all;
        for (const std::string& word : words) all += word + " ";
        EXPECT_EQ(ran.code, 2) << all;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << all << ran.err;
        EXPECT_EQ(ran.out, "") << all;
        EXPECT_EQ(names(), "") << all;
    }
}

}  // namespace
}  // namespace sunfleck::engine
