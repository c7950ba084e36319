// Light groups as a user meets them: the flag, the statistics.
#include "app/determinism_support.h"
#include "image/exr.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;
using testing_support::operator+;
using testing_support::read_text;

class LightStrata : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("useless-light", {"--resolution", "12x12", "--photons-per-pass", "3000"});
    }
};

TEST_F(LightStrata, are_told_in_the_statistics) {
    const auto s = stats("0:3", {"--seed", "7"});  // one whose pilot finds the sun's light
    ASSERT_EQ(s["light_strata"].size(), 2U);
    const auto& lamp = s["light_strata"][0];
    const auto& sun = s["light_strata"][1];
    for (const auto& group : {lamp, sun}) {
        EXPECT_EQ(group["passes"], 3);
        EXPECT_LE(group["starved_passes"], 3);
    }
    EXPECT_NEAR(lamp["power_share"].get<double>() + sun["power_share"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(sun["power_share"].get<double>() / lamp["power_share"].get<double>(), 100, 3);
    EXPECT_GT(lamp["visible_fraction"], 0.05);
    EXPECT_LT(sun["visible_fraction"], 1e-3);
    EXPECT_NEAR(lamp["paths"], 3000 / 1.1, 3);
    EXPECT_NEAR(sun["paths"], 300 / 1.1, 3);
    EXPECT_EQ(lamp["splitting"]["levels"], 0);
    EXPECT_GT(sun["splitting"]["levels"], 0);
    EXPECT_TRUE(lamp["splitting"]["lineages"].is_null());
    EXPECT_GE(sun["splitting"]["lineages"]["runs"], sun["passes"]);
    EXPECT_GT(sun["splitting"]["lineages"]["largest_share"], 0);
    EXPECT_LE(sun["splitting"]["lineages"]["largest_share"], 1);
    EXPECT_EQ(sun["splitting"]["fractions"].size(), sun["splitting"]["levels"]);
    EXPECT_EQ(s["splitting"]["levels"], 0);  // of all lights together: there is none
    // Light that is not there needs no group, nor do other samplers part it.
    EXPECT_TRUE(stats("0:1", {"--light-strata", "off"})["light_strata"].empty());
    EXPECT_TRUE(stats("0:1", {"--photon-sampler", "uniform"})["light_strata"].empty());
    use("useful-light", {"--resolution", "12x12", "--photons-per-pass", "3000"});
    EXPECT_TRUE(stats("0:1")["light_strata"].empty());
}

TEST_F(LightStrata, are_on_unless_they_are_switched_off) {
    const auto plain = stats("0:1");
    const auto light = [&] { return read_exr(path("x.exr")).channels; };  // without the settings
    const std::string bytes = read_text(path("x.exr"));
    const std::vector<Channel> with_strata = light();
    EXPECT_FALSE(plain["settings"].contains("light_strata"));
    EXPECT_EQ(stats("0:1", {"--light-strata", "auto"})["settings"], plain["settings"]);
    EXPECT_EQ(read_text(path("x.exr")), bytes);
    EXPECT_EQ(stats("0:1", {"--light-strata", "off"})["settings"]["light_strata"], "off");
    EXPECT_NE(light(), with_strata);
    // Of a single lamp the picture is the same.
    use("useful-light", {"--resolution", "12x12", "--photons-per-pass", "3000"});
    stats("0:1");
    const std::vector<Channel> one = light();
    stats("0:1", {"--light-strata", "off"});
    EXPECT_EQ(light(), one);
}

}  // namespace
}  // namespace sunfleck::engine
