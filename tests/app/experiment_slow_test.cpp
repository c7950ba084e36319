// `sunfleck experiment`: a small figure from end to end, going on, and being interrupted.
#include "app/program.h"

#include <filesystem>

namespace sunfleck {
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

    const auto written = fs::last_write_time(path("run/cells/cornell-door/target-0.9/seed-2"));
    const Ran again = run(small("fig8"));
    EXPECT_EQ(again.code, 0);
    EXPECT_TRUE(again.out.starts_with("9 renders, 9 of them done\n")) << again.out;
    EXPECT_EQ(fs::last_write_time(path("run/cells/cornell-door/target-0.9/seed-2")), written);

    Words other = small("fig8");
    other[3] = "2";
    const Ran differs = run(other);
    EXPECT_EQ(differs.code, 2);
    EXPECT_NE(differs.err.find("was begun with passes 1, and is asked to go on with 2"),
              std::string::npos)
        << differs.err;
}

TEST_F(ExperimentRun, interrupted_keeps_what_is_finished) {
    Words longer = small("fig8");
    longer[3] = "40";
    Process process(path(""), longer);
    const std::string first = path("run/cells/cornell-door/reference-uniform/seed-1000");
    for (int i = 0; i < 600 && !fs::exists(first); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    process.send(SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 130) << ran.err;
    EXPECT_TRUE(fs::exists(first));
    for (const auto& entry : fs::recursive_directory_iterator(path("run/cells")))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
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
}  // namespace sunfleck
