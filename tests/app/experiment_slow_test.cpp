// `sunfleck experiment`: a small figure from end to end, going on, and being interrupted.
#include "app/program.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

class ExperimentRun : public ProgramTest {
protected:
    static Words small(const std::string& figure) {
        return {"experiment", figure, "--passes",           "1", "--scale", "0.04", "--seeds", "2",
                "-o",         "run",  "--reference-budget", "1"};
    }
    std::string file(const std::string& name) const { return read_text(path("run/" + name)); }
};

/// Four targets, two seeds, a reference; what is done is not done again.
TEST_F(ExperimentRun, makes_a_figure_and_goes_on) {
    const Ran ran = run(small("fig8"));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with("9 renders, 0 of them done\n")) << ran.out;
    const std::string csv = file("tables/fig8-errors.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6) << csv;
    const auto json = nlohmann::json::parse(file("results.json"));
    EXPECT_EQ(json["cells"].size(), 9U);
    for (const auto& cell : json["cells"]) {
        EXPECT_GT(cell["cpu_seconds"].get<double>(), 0);
        EXPECT_TRUE(cell["rel_mse"].is_number());
    }
    EXPECT_NE(file("index.html").find("pictures/fig8-cornell-door-target-0.9.png"),
              std::string::npos);
    EXPECT_FALSE(file("pictures/fig8-cornell-door-target-0.9.png").empty());
    EXPECT_NE(file("index.html").find("<a href=\"compare/fig8-cornell-door.html\">"),
              std::string::npos);
    const std::string comparison = file("compare/fig8-cornell-door.html");
    for (const char* shown : {"\"cornell-door, reference\"", "\"target-0.05, ", "\"target-0.9, "})
        EXPECT_NE(comparison.find(shown), std::string::npos) << shown;

    const auto written = fs::last_write_time(path("run/cells/cornell-door/target-0.9/seed-2"));
    const Ran again = run(small("fig8"));
    EXPECT_EQ(again.code, 0);
    EXPECT_TRUE(again.out.starts_with("9 renders, 9 of them done\n")) << again.out;
    EXPECT_EQ(fs::last_write_time(path("run/cells/cornell-door/target-0.9/seed-2")), written);

    Words other = small("fig8");
    other[3] = "2";
    const Ran differs = run(other);
    EXPECT_EQ(differs.code, 2);
    EXPECT_NE(differs.err.find("was begun with passes 1, not 2"), std::string::npos) << differs.err;
}

/// Finished cells are kept, the one under way goes on, and nothing shows in the end.
TEST_F(ExperimentRun, goes_on_where_it_was_interrupted) {
    Words longer = small("fig5");
    longer[3] = "3";
    Process process(path(""), longer);
    const std::string cells = path("run/cells/room/");
    for (int i = 0; i < 6000 && !fs::exists(cells + "adaptive/seed-1.part/passes-000001.exr"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 130);
    EXPECT_TRUE(fs::exists(cells + "reference-uniform/seed-1000"));
    EXPECT_TRUE(fs::exists(cells + "adaptive/seed-1.part/render.ckpt"));
    const Ran again = run(longer);
    ASSERT_EQ(again.code, 0) << again.err;
    Words whole = longer;
    whole[9] = "whole";
    ASSERT_EQ(run(whole).code, 0);
    const std::string last = "cells/room/adaptive/seed-1/passes-000003.exr";
    EXPECT_EQ(read_text(path("run/" + last)), read_text(path("whole/" + last)));
    const auto count = [&](const std::string& folder) {
        const auto all = fs::recursive_directory_iterator(path(folder));
        return std::distance(begin(all), end(all));
    };
    EXPECT_EQ(count("run"), count("whole"));
}

TEST_F(ExperimentRun, says_why_a_render_failed) {
    fs::create_directories(path("run/scenes/cornell-door"));
    write_text(path("run/scenes/cornell-door/cornell-door.pbrt"), "Film 1\n");
    const Ran ran = run(small("fig8"));
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("the render ended with code 2"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("cornell-door.pbrt:1:"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace sunfleck::engine
