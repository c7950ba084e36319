// stats.json: every name that docs/reference/stats.md promises, with sound values.
#include "app/program.h"

#include <set>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

class Stats : public ProgramTest {
protected:
    nlohmann::json stats(const Words& words) const {
        using testing_support::operator+;
        const auto ran = render(Words{"-o", "x.exr", "--stats", "x.json"} + words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json("x.json");
    }
};

/// "a", "a.b" for all of an object, but of "settings" (docs/reference/stats.md lists those apart).
void add_names(const nlohmann::json& object, const std::string& prefix,
               std::set<std::string>& names) {
    for (const auto& [name, value] : object.items()) {
        names.insert(prefix + name);
        if (value.is_object() && name != "settings") add_names(value, prefix + name + ".", names);
    }
}

TEST_F(Stats, are_those_of_the_documentation) {
    const std::string document = read_text(SUNFLECK_SOURCE_DIR "/docs/reference/stats.md");
    std::set<std::string> promised;
    for (std::size_t at = document.find("\n| `"); at != std::string::npos;
         at = document.find("\n| `", at + 1))
        promised.insert(document.substr(at + 4, document.find('`', at + 4) - at - 4));
    std::set<std::string> given;
    add_names(stats({"--passes", "64"}), "", given);
    EXPECT_EQ(given, promised);
}

TEST_F(Stats, add_up) {
    const auto s = stats({"--passes", "32", "--seed", "5", "--nthreads", "2", "--adaptive-pixels",
                          "off", "--indirect", "photons"});
    EXPECT_EQ(s["version"], SUNFLECK_VERSION);
    EXPECT_EQ(s["scene"], "room.pbrt");
    EXPECT_NE(s["command"].get<std::string>().find("--seed 5"), std::string::npos);
    EXPECT_EQ(s["seed"], 5);
    EXPECT_EQ(s["threads"], 2);
    EXPECT_EQ(s["isa"], "avx2");
    EXPECT_EQ(s["resolution"], (nlohmann::json{16, 12}));
    EXPECT_EQ(s["passes"], 32);
    EXPECT_EQ(s["batches"], 8);  // seven of them early
    const auto& paths = s["photon_paths"];
    EXPECT_EQ(paths["uniform"], 32 * 2000);
    EXPECT_LE(paths["uniform_visible"], paths["uniform"]);
    EXPECT_GT(paths["uniform_visible"], 0);
    EXPECT_DOUBLE_EQ(s["visible_fraction"]["value"].get<double>(),
                     paths["uniform_visible"].get<double>() / (32 * 2000));
    EXPECT_GT(s["visible_fraction"]["std_error"], 0);
    EXPECT_LT(s["visible_fraction"]["std_error"], 0.1);
    EXPECT_GE(s["rays"]["photon"], paths["uniform"]);
    EXPECT_GE(s["rays"]["camera"], 32 * 16 * 12);
    EXPECT_GT(s["visible_points"], 32 * 16 * 12);  // paths part at the glass ball
    EXPECT_LE(s["visible_points"], 2 * 32 * 16 * 12);
    EXPECT_GE(s["deposits"], s["photons_stored"]);
    EXPECT_GE(s["photons_stored"], paths["uniform_visible"]);
    EXPECT_EQ(s["escaped"], 0);  // the room is closed
    EXPECT_EQ(s["starved_passes"], 0);
    EXPECT_EQ(s["dropped_nonfinite"], 0);
    EXPECT_EQ(s["saturated"], 0);
    double sum = 0;
    for (const auto& [name, seconds] : s["seconds"].items()) {
        EXPECT_GE(seconds, 0) << name;
        if (name != "total") sum += seconds.get<double>();
    }
    EXPECT_LE(sum, s["seconds"]["total"]);
    EXPECT_GT(s["image"]["mean"], 0);
    EXPECT_LT(s["image"]["mean_std_error"], 0.2 * s["image"]["mean"].get<double>());
}

/// Knaus and Zwicker 2011: r_p^2 / r_0^2 = product of (k + alpha) / (k + 1), k = 1 ... p.
TEST_F(Stats, radius_factor_is_that_of_the_last_pass) {
    const double factor = stats({"--pass-range", "1:3", "--alpha", "0.5"})["radius_factor"];
    EXPECT_NEAR(factor * factor, 1.5 / 2 * 2.5 / 3, 1e-12);
    EXPECT_EQ(stats({"--passes", "1"})["radius_factor"], 1);
}

TEST_F(Stats, starved_passes_are_counted_and_warned_of) {
    const auto s = stats({"--passes", "20", "--photons-per-pass", "1", "--radius", "0.001"});
    EXPECT_GT(s["starved_passes"], 15);
    EXPECT_NE(s["warnings"].dump().find("no photon reached"), std::string::npos);
}

/// A small part of a wall, and one photon a pass, which meets it in one of thirty: of some seed two
/// batches are black and the passes after them are not. An error of zero would say that the picture
/// is known.
TEST_F(Stats, error_of_light_in_an_open_batch_alone_is_absent) {
    write_text(path("room.pbrt"),
               "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 20\n"
               "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4\nWorldBegin\n"
               "LightSource \"point\" \"point3 from\" [0 0 2]\n"
               "Shape \"disk\" \"float radius\" 9\n");
    const auto image = [&](int seed, const char* passes) -> nlohmann::json {
        return stats({"--passes", passes, "--seed", std::to_string(seed), "--direct", "photons",
                      "--photons-per-pass", "1"})["image"];
    };
    for (int seed = 0; seed < 60; ++seed) {
        const auto dark = image(seed, "32");
        if (dark["mean"] != 0) continue;
        EXPECT_EQ(dark["mean_std_error"], 0) << "black";
        const auto lit = image(seed, "47");
        if (lit["mean"] == 0) continue;
        EXPECT_FALSE(lit.contains("mean_std_error"));
        EXPECT_FALSE(lit.contains("relative_std_error"));
        return;
    }
    FAIL() << "no such seed";
}

/// Times and the command aside, the numbers of two runs are the same.
TEST_F(Stats, are_reproducible) {
    auto once = stats({"--passes", "17", "--nthreads", "1"});
    auto again = stats({"--passes", "17", "--nthreads", "3"});
    for (const char* name : {"seconds", "cpu_seconds", "command", "threads"}) {
        once.erase(name);
        again.erase(name);
    }
    EXPECT_EQ(once, again);
}

/// Eight wavelengths a pass seldom meet a lamp of 585 to 590 nm: paths that have no light to bring
/// are as long as others, also where there is something that absorbs.
TEST_F(Stats, paths_without_light_end_as_others_do) {
    std::string text = room_text("0.6");
    const std::string lamp = "\"rgb L\" [5 5 5]";
    text.replace(text.find(lamp), lamp.size(), "\"spectrum L\" [585 0 586 1 589 1 590 0]");
    const std::string ball_of_tea = R"(
MakeNamedMedium "tea" "string type" "homogeneous" "rgb sigma_s" [0 0 0] "rgb sigma_a" [1 2 3]
Translate -0.6 0 0
Material "interface"
MediumInterface "tea" ""
Shape "sphere" "float radius" 0.1
)";
    for (const std::string& more : {std::string(), ball_of_tea}) {
        write_text(path("room.pbrt"), text + more);
        const auto of =
            stats({"--passes", "16", "--max-depth", "64", "--photon-sampler", "uniform"});
        EXPECT_EQ(of["too_long"], 0) << more;
        const auto paths = of["photon_paths"]["uniform"].get<double>();
        const auto rays = of["rays"]["photon"].get<double>();
        EXPECT_GT(rays, 1.5 * paths) << more;
        EXPECT_LT(rays, 3 * paths) << more;
    }
}

}  // namespace
}  // namespace sunfleck::engine
