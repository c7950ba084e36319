// --extrapolate and --target-error-of: what they do to pictures, statistics and the end of a
// render, and where they are refused.
#include "app/program.h"
#include "image/exr.h"

#include <numeric>
#include <vector>

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;

class Extrapolate : public ProgramTest {
protected:
    Ran render_to(const std::string& name, const Words& words) const {
        Ran ran = render(Words{"-o", name + ".exr", "--stats", name + ".json", "--radius-pixels",
                               "4", "--nthreads", "2"} +
                         words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran;
    }
    /// Refused with one line that begins with the flag.
    void expect_refused(const Words& words, const std::string& flag) const {
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 2) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_TRUE(ran.err.starts_with(flag + ": ")) << ran.err;
    }
};

TEST_F(Extrapolate, subtracts_the_bias_from_the_picture_alone) {
    const Words films{"-o", "plain.film"};
    render_to("plain", Words{"--passes", "64", "--aovs", "caustic"} + films);
    const Ran ran = render_to("zero", {"--passes", "64", "--aovs", "caustic", "-o", "zero.film",
                                       "--extrapolate", "on", "--log-level", "warning"});
    EXPECT_EQ(ran.err, "");
    const Picture plain = read_exr(path("plain.exr"));
    const Picture zero = read_exr(path("zero.exr"));
    bool differs = false;
    for (const std::string c : {"R", "G", "B"})
        for (std::size_t i = 0; i < plain.pixels(); ++i) {
            const float bias = plain.find("bias." + c)->values[i];
            EXPECT_EQ(zero.find(c)->values[i], plain.find(c)->values[i] - bias);
            differs = differs || bias != 0;
        }
    EXPECT_TRUE(differs);
    EXPECT_EQ(zero.find("caustic.G")->values, plain.find("caustic.G")->values);
    const auto all_errors = [](const Picture& picture) {
        const std::vector<float>& errors = picture.find("error.Y")->values;
        return std::accumulate(errors.begin(), errors.end(), 0.0);
    };
    EXPECT_GT(all_errors(zero), all_errors(plain));
    EXPECT_EQ(zero.metadata.count("extrapolated"), 1U);
    EXPECT_EQ(plain.metadata.count("extrapolated"), 0U);
    EXPECT_EQ(read_text(path("plain.film")), read_text(path("zero.film")));
    const auto of_plain = json("plain.json")["image"];
    const auto of_zero = json("zero.json")["image"];
    EXPECT_EQ(of_plain["extrapolated"], false);
    EXPECT_EQ(of_zero["extrapolated"], true);
    for (const char* name : {"mean", "bias", "bias_std_error", "relative_bias"})
        EXPECT_EQ(of_plain[name], of_zero[name]) << name;
    EXPECT_GT(of_zero["noise"], of_plain["noise"]);
    EXPECT_EQ(of_zero["target_error"], of_zero["noise"]);
}

TEST_F(Extrapolate, of_merged_films_is_that_of_one_render) {
    render_to("a", {"--pass-range", "0:23", "-o", "a.film"});
    render_to("b", {"--pass-range", "23:70", "-o", "b.film"});
    render_to("whole", {"--passes", "70", "--extrapolate", "on"});
    const Ran ran = run(
        {"merge", "b.film", "a.film", "-o", "x.exr", "--extrapolate", "on", "--stats", "x.json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("whole.exr")));
    EXPECT_EQ(json("x.json")["image"], json("whole.json")["image"]);
}

TEST_F(Extrapolate, is_in_snapshots_and_goes_on_from_checkpoints) {
    render_to("whole", {"--passes", "66", "--extrapolate", "on", "--snapshots", "seen"});
    EXPECT_EQ(read_text(path("seen/passes-000066.exr")), read_text(path("whole.exr")));
    render_to("begun", {"--passes", "30", "--checkpoint", "x.ckpt"});
    render_to("resumed", {"--passes", "66", "--resume", "x.ckpt", "--extrapolate", "on"});
    EXPECT_EQ(read_text(path("resumed.exr")), read_text(path("whole.exr")));
}

TEST_F(Extrapolate, of_too_few_batches_is_the_plain_picture_with_a_warning) {
    render_to("plain", {"--passes", "63", "-o", "plain.film"});
    const Ran ran =
        render_to("zero", {"--passes", "63", "--extrapolate", "on", "--log-level", "warning"});
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find("4 complete batches of 16 passes on, of which it has 3"),
              std::string::npos);
    EXPECT_EQ(read_text(path("plain.exr")), read_text(path("zero.exr")));
    const auto stats = json("zero.json");
    EXPECT_EQ(stats["image"]["extrapolated"], false);
    EXPECT_NE(stats["warnings"].dump().find("not extrapolated"), std::string::npos);
    const Ran merged = run({"merge", "plain.film", "-o", "x.exr", "--extrapolate", "on"});
    EXPECT_EQ(merged.code, 0);
    EXPECT_EQ(merged.err, ran.err);
    EXPECT_EQ(read_text(path("x.exr")), read_text(path("plain.exr")));
    const Ran flat =
        render_to("flat", {"--passes", "64", "--alpha", "0.99", "--extrapolate", "on"});
    EXPECT_NE(flat.err.find("radii have hardly shrunk"), std::string::npos) << flat.err;
}

TEST_F(Extrapolate, has_no_meaning_without_discs_that_shrink) {
    const Words few{"render", "room.pbrt", "-o", "x.exr", "--passes", "1"};
    const Words of_path = few + Words{"--integrator", "path"};
    const Words of_paper = few + Words{"--mode", "paper"};
    for (const std::string flag : {"--extrapolate", "--target-error-of"})
        for (const Words& words : {of_path, of_paper})
            expect_refused(words + Words{flag, flag == "--extrapolate" ? "on" : "noise"}, flag);
    ASSERT_EQ(run(of_path + Words{"-o", "x.film"}).code, 0);
    expect_refused({"merge", "x.film", "-o", "y.exr", "--extrapolate", "on"}, "--extrapolate");
    EXPECT_FALSE(exists("y.exr"));
    for (const Words& words : {Words{"--extrapolate", "yes"}, {"--target-error-of", "bias"}}) {
        const Ran ran = render(words + Words{"-o", "y.exr"});
        EXPECT_EQ(ran.code, 2);
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_FALSE(exists("y.exr"));
    }
}

/// Large discs that lose light at edges: noise reaches the target first, bias and noise together
/// later.
TEST_F(Extrapolate, the_target_error_holds_the_bias) {
    const Words words{"--radius-pixels", "8",       "--target-error", "8%", "--passes", "3000",
                      "--indirect",      "photons", "--edges",        "off"};
    const auto stats = [&](const Words& more) {
        const Ran ran = render(Words{"-o", "x.exr", "--stats", "x.json"} + words + more);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json("x.json");
    };
    const auto of_all = stats({});
    const auto of_noise = stats({"--target-error-of", "noise"});
    EXPECT_GT(of_all["passes"], of_noise["passes"]);
    EXPECT_EQ(of_noise["image"]["target_error"], of_noise["image"]["noise"]);
    EXPECT_LE(of_noise["image"]["noise"], 0.08);
    const double noise = of_all["image"]["noise"];
    const double bias = of_all["image"]["relative_bias"];
    EXPECT_DOUBLE_EQ(of_all["image"]["target_error"], std::sqrt(noise * noise + bias * bias));
    EXPECT_LE(of_all["image"]["target_error"], 0.08);
    EXPECT_GT(std::hypot(of_noise["image"]["noise"].get<double>(),
                         of_noise["image"]["relative_bias"].get<double>()),
              0.08);
    EXPECT_EQ(stats({"--target-error-of", "all"})["passes"], of_all["passes"]);
    const auto extrapolated = stats({"--extrapolate", "on"});
    EXPECT_LE(extrapolated["image"]["noise"], 0.08);
    EXPECT_GE(extrapolated["passes"], of_noise["passes"]);
}

}  // namespace
}  // namespace sunfleck::engine
