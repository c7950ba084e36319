// The flags of the sampler `paper`: what each changes, and what is refused.
#include "app/program.h"
#include "image/exr.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;

class PaperFlags : public ProgramTest {
protected:
    nlohmann::json rendered(const Words& words) const {
        const Ran ran = render(Words{"-o", "x.exr", "--stats", "x.json"} + words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json("x.json");
    }
};

TEST_F(PaperFlags, sampler_and_mode_are_one) {
    const Words passes{"--passes", "33", "--photons-per-pass", "500"};
    const auto s = rendered(passes + Words{"--mode", "paper"});
    const std::string bytes = read_text(path("x.exr"));
    EXPECT_EQ(s["settings"]["photon_sampler"], "paper");
    EXPECT_EQ(s["settings"]["direct"], "photons");
    EXPECT_EQ(s["settings"]["alpha"], "0.7");
    EXPECT_EQ(s["settings"]["radius_pixels"], "2");
    EXPECT_EQ(s["settings"]["indirect_radius"], "1");
    EXPECT_EQ(s["settings"]["replica_exchange"], "on");
    EXPECT_EQ(s["settings"]["mutation_size"], "adaptive");
    EXPECT_EQ(s["settings"]["target_acceptance"], "0.234");
    EXPECT_EQ(s["photon_paths"]["uniform"], 33 * 500);
    EXPECT_GT(s["mutation_size"], 0);
    EXPECT_GT(s["acceptance"], 0);
    EXPECT_NE(s["warnings"].dump().find("biased"), std::string::npos);
    EXPECT_EQ(s["batches"], 0);
    EXPECT_FALSE(s["image"].contains("mean_std_error"));
    EXPECT_EQ(read_exr(path("x.exr")).find("error.Y"), nullptr);
    const auto other = rendered(passes + Words{"--photon-sampler", "paper", "--direct", "photons"});
    EXPECT_EQ(other["settings"], s["settings"]);
    EXPECT_EQ(read_text(path("x.exr")), bytes);
}

TEST_F(PaperFlags, say_at_the_start_that_the_picture_is_biased) {
    const Ran ran =
        render({"-o", "x.exr", "--mode", "paper", "--passes", "1", "--log-level", "warning"});
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("sampler paper: ")) << ran.err;
    EXPECT_NE(ran.err.find("biased"), std::string::npos);
    EXPECT_EQ(render({"-o", "x.exr", "--mode", "paper", "--passes", "1", "--quiet"}).err, "");
}

TEST_F(PaperFlags, change_the_picture_and_are_recorded) {
    const Words base{"--mode", "paper", "--passes", "2", "--photons-per-pass", "2000"};
    const auto plain = rendered(base);
    const std::vector<Channel> light = read_exr(path("x.exr")).channels;
    struct Row {
        Words words;
        const char* name;
        const char* value;
    };
    const std::vector<Row> rows = {
        {{"--replica-exchange", "off"}, "replica_exchange", "off"},
        {{"--mutation-size", "0.25"}, "mutation_size", "0.25"},
        {{"--target-acceptance", "0.9"}, "target_acceptance", "0.9"},
        {{"--alpha", "0.5"}, "alpha", "0.5"},
        {{"--radius-pixels", "5"}, "radius_pixels", "5"},
    };
    for (const Row& row : rows) {
        const auto s = rendered(base + row.words);
        EXPECT_EQ(s["settings"][row.name], row.value);
        EXPECT_NE(plain["settings"][row.name], row.value);
        EXPECT_TRUE(read_exr(path("x.exr")).channels != light) << row.name;
    }
    EXPECT_EQ(rendered(base + Words{"--mutation-size", "0.25"})["mutation_size"], 0.25);
}

TEST_F(PaperFlags, are_refused_in_one_line) {
    const Words paper{"--mode", "paper"};
    const std::vector<Words> bad = {
        {"--mode", "fast"},
        {"--replica-exchange", "on"},
        {"--mutation-size", "0.5"},
        {"--mutation-size", "adaptive"},
        {"--target-acceptance", "0.3"},
        {"--photon-sampler", "uniform", "--target-acceptance", "0.3"},
        paper + Words{"--photon-sampler", "random"},
        paper + Words{"--direct", "sampled"},
        paper + Words{"--pass-range", "0:4"},
        paper + Words{"--indirect-radius", "2"},
        paper + Words{"--target-error", "2%"},
        paper + Words{"--integrator", "path"},
        paper + Words{"--replica-exchange", "maybe"},
        paper + Words{"--mutation-size", "0"},
        paper + Words{"--mutation-size", "-1"},
        paper + Words{"--mutation-size", "nan"},
        paper + Words{"--mutation-size", "inf"},
        paper + Words{"--mutation-size", "1x"},
        paper + Words{"--target-acceptance", "0"},
        paper + Words{"--target-acceptance", "1"},
        paper + Words{"--target-acceptance", "20%"},
        paper + Words{"--mutation-size", "0.5", "--target-acceptance", "0.3"},
    };
    for (const Words& words : bad) {
        const Ran ran = render(Words{"-o", "x.exr"} + words);
        std::string all;
        for (const std::string& word : words) all += word + " ";
        EXPECT_EQ(ran.code, 2) << all;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << all << ran.err;
        EXPECT_TRUE(ran.err.starts_with("--") || ran.err.starts_with("sunfleck: ")) << ran.err;
        EXPECT_EQ(names(), "") << all;
    }
}

TEST_F(PaperFlags, films_are_not_merged) {
    for (const char* seed : {"1", "2"})
        ASSERT_EQ(render({"-o", std::string(seed) + ".film", "--mode", "paper", "--passes", "2",
                          "--quiet"})
                      .code,
                  0);
    const Ran ran = run({"merge", "1.film", "1.film", "-o", "x.exr"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("1.film: its passes depend on each other"), std::string::npos)
        << ran.err;
    EXPECT_FALSE(exists("x.exr"));
    EXPECT_EQ(run({"merge", "1.film", "-o", "x.exr"}).code, 0) << "one alone is copied";
}

}  // namespace
}  // namespace sunfleck::engine
