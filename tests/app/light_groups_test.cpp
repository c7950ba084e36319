// Aovs of lights as a user meets them: the list of lights, the flag, the picture's AOVs, and
// lamps dimmed afterwards.
#include "app/determinism_support.h"
#include "image/exr.h"

#include <sstream>

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;
using testing_support::Ran;
using testing_support::Words;
using testing_support::operator+;
using testing_support::write_text;

class LightGroupsApp : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("useless-light",
            {"--resolution", "12x12", "--photons-per-pass", "3000", "--light-group", "each"});
    }

    /// Channel names, without those of the picture itself.
    std::vector<std::string> aov_channels(const std::string& name) const {
        std::vector<std::string> names;
        for (const Channel& channel : read_exr(path(name)).channels)
            if (channel.name.find('.') != std::string::npos) names.push_back(channel.name);
        return names;
    }
};

TEST_F(LightGroupsApp, lights_are_listed_by_number) {
    const Ran ran = run({"info", "useless-light.pbrt", "--lights"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    std::istringstream lines(ran.out);
    std::vector<std::string> lights;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("light ")) lights.push_back(line);
    ASSERT_EQ(lights.size(), 2U) << ran.out;
    EXPECT_TRUE(lights[0].starts_with("light       1 ")) << lights[0];
    EXPECT_TRUE(lights[1].starts_with("light       2 ")) << lights[1];
    for (const std::string& light : lights) {
        EXPECT_NE(light.find("ightSource \""), std::string::npos) << light;
        EXPECT_NE(light.find(" at useless-light.pbrt:"), std::string::npos) << light;
        EXPECT_NE(light.find("% of the photons)"), std::string::npos) << light;
    }
    EXPECT_EQ(run({"info", "useless-light.pbrt"}).out.find("\nlight  "), std::string::npos);
    EXPECT_EQ(run({"info", "--lights"}).code, 2);
}

TEST_F(LightGroupsApp, each_light_or_named_ones_have_a_layer) {
    part("each", "0:1", 2);
    EXPECT_EQ(aov_channels("each.exr"),
              (std::vector<std::string>{"light1.B", "light1.G", "light1.R", "light2.B", "light2.G",
                                        "light2.R"}));
    ASSERT_EQ(run({"render", "useless-light.pbrt", "--quiet", "--resolution", "12x12",
                   "--photons-per-pass", "3000", "--passes", "1", "--light-group", "a-1=2",
                   "--light-group", "B_=1", "-o", "named.exr"})
                  .code,
              0);
    const Picture each = read_exr(path("each.exr"));
    const Picture named = read_exr(path("named.exr"));
    EXPECT_EQ(each.find("light2.G")->values, named.find("a-1.G")->values);
    EXPECT_EQ(each.find("light1.R")->values, named.find("B_.R")->values);
    EXPECT_EQ(each.find("R")->values, named.find("R")->values);
    EXPECT_EQ(named.metadata.at("light_groups"), "a-1 B_");
}

TEST_F(LightGroupsApp, films_with_other_layers_do_not_mix) {
    part("a", "0:1", 1);
    const Words render{"render", "useless-light.pbrt", "--quiet", "--resolution",
                       "12x12",  "--photons-per-pass", "3000",    "--pass-range",
                       "1:2"};
    ASSERT_EQ(run(render + Words{"-o", "none.film"}).code, 0);
    ASSERT_EQ(run(render + Words{"--light-group", "light1=2", "--light-group", "light2=1", "-o",
                                 "other.film"})
                  .code,
              0);
    for (const auto& [film, what] :
         {std::pair("none.film", "set of AOVs"),
          std::pair("other.film", "output_light_groups=light1=1 light2=2")}) {
        const Ran merged = run({"merge", "a.film", film, "-o", "x.exr"});
        EXPECT_EQ(merged.code, 2);
        EXPECT_NE(merged.err.find(what), std::string::npos) << merged.err;
    }
}

TEST_F(LightGroupsApp, what_cannot_be_a_layer_is_refused) {
    use("useless-light", {});
    const auto aov = [](const std::string& text) { return Words{"--light-group", text}; };
    expect_refused("--light-group", {aov(""),
                                     aov("a"),
                                     aov("a="),
                                     aov("=1"),
                                     aov("a=0"),
                                     aov("a=3"),
                                     aov("a=2-1"),
                                     aov("a=1,"),
                                     aov("a=1;2"),
                                     aov("a=1-"),
                                     aov("a=x"),
                                     aov("a b=1"),
                                     aov("1a=1"),
                                     aov("a.b=1"),
                                     aov("direct=1"),
                                     aov("error=1"),
                                     aov("bias=1"),
                                     aov("a=1") + aov("a=2"),
                                     aov("a=1-2") + aov("b=2"),
                                     aov("each") + aov("b=2"),
                                     aov("a=99999999999"),
                                     aov("a=1") + Words{"--mode", "paper"},
                                     aov("each") + Words{"--integrator", "path"}});
}

TEST_F(LightGroupsApp, more_lights_than_layers_are_refused) {
    std::string scene = "WorldBegin\n";
    for (int i = 0; i < 65; ++i) scene += "LightSource \"point\"\n";
    write_text(path("many.pbrt"), scene);
    const Ran ran = run({"render", "many.pbrt", "--light-group", "each", "-o", "x.exr"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("put lights together: at most 64 groups"), std::string::npos) << ran.err;
    EXPECT_EQ(run({"render", "many.pbrt", "--quiet", "--light-group", "all=1-65", "--resolution",
                   "2x2", "--passes", "1", "-o", "x.exr"})
                  .code,
              0);
}

/// The sun outside switched off is nearly the scene without it.
TEST_F(LightGroupsApp, a_lamp_is_dimmed_after_the_render) {
    part("lit", "0:1", 2);
    const Picture lit = read_exr(path("lit.exr"));
    const Ran ran = run({"relight", "lit.exr", "light1=0.5", "light2=1,0,2", "-o", "dim.exr", "-o",
                         "dim.png", "--exposure", "1"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(exists("dim.png"));
    const Picture dim = read_exr(path("dim.exr"));
    for (std::size_t i = 0; i < lit.pixels(); ++i) {
        const auto at = [&](const char* name) { return lit.find(name)->values[i]; };
        EXPECT_FLOAT_EQ(dim.find("R")->values[i], at("R") - 0.5F * at("light1.R"));
        EXPECT_NEAR(dim.find("B")->values[i], at("B") - 0.5F * at("light1.B") + at("light2.B"),
                    1e-5F * at("B"));
    }
    const auto refused = [&](const Words& words, const std::string& what) {
        const Ran bad = run(Words{"relight"} + words);
        EXPECT_EQ(bad.code, 2);
        EXPECT_EQ(std::count(bad.err.begin(), bad.err.end(), '\n'), 1) << bad.err;
        EXPECT_NE(bad.err.find(what), std::string::npos) << bad.err;
    };
    for (const char* bad : {"light1", "light1=", "=1", "light1=x", "light1=-1", "light1=1,2",
                            "light1=1,2,3,4", "light1=nan", "light1=2e6", "light1=1x", "light1=1,"})
        refused({"lit.exr", bad, "-o", "x.exr"}, std::string("\"") + bad + "\"");
    refused({"lit.exr", "sun=1", "-o", "x.exr"}, "use some of light1, light2");
    refused({"none.exr", "light1=1", "-o", "x.exr"}, "none.exr");
    refused({"lit.exr", "light1=1", "-o", "x.film"}, "x.film");
    EXPECT_FALSE(exists("x.exr"));
}

}  // namespace
}  // namespace sunfleck::engine
