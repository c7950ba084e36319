// `sunfleck compare` and the snapshots that it reads, from the outside.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;

class Compare : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        render({"-o", "r.exr", "--passes", "4"});
        render({"-o", "a.exr", "--passes", "2", "--seed", "3"});
    }

    void expect_refused(const Words& words, const std::string& names_it) const {
        const std::string before = names();
        const Ran ran = run(Words{"compare"} + words);
        EXPECT_EQ(ran.code, 2) << names_it;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_NE(ran.err.find(names_it), std::string::npos) << ran.err;
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(names(), before);
    }
};

TEST_F(Compare, prints_a_table) {
    const Ran ran = run({"compare", "r.exr", "a.exr", "same=r.exr"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 3) << ran.out;
    EXPECT_NE(ran.out.find("relMSE"), std::string::npos);
    EXPECT_NE(ran.out.find("\nsame "), std::string::npos);
    EXPECT_EQ(names(), "a.exr r.exr");
}

TEST_F(Compare, writes_a_page_and_numbers) {
    const Ran ran =
        run({"compare", "r.exr", "a.exr", "same=r.exr", "--report", "x.html", "--json", "x.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto numbers = json("x.json");
    EXPECT_GT(numbers["pictures"][0]["metrics"]["mse"], 0);
    EXPECT_EQ(numbers["pictures"][1]["metrics"]["mse"], 0);
    const std::string page = read_text(path("x.html"));
    EXPECT_TRUE(page.starts_with("<!doctype html>"));
    EXPECT_NE(page.find("id=\"pixels-2\""), std::string::npos);
}

TEST_F(Compare, gives_the_same_bytes_again) {
    for (const char* name : {"1.html", "2.html"})
        run({"compare", "r.exr", "a.exr", "--report", name});
    EXPECT_EQ(read_text(path("1.html")), read_text(path("2.html")));
}

TEST_F(Compare, bad_input_is_one_line_and_no_file) {
    render({"-o", "small.exr", "--passes", "1", "--resolution", "8x8"});
    const Words page{"--report", "x.html", "--json", "x.json"};
    expect_refused({}, "REF");
    expect_refused({"r.exr"}, "PICTURES");
    expect_refused(Words{"r.exr", "small.exr"} + page, "8 x 8 pixels, but the reference 16 x 12");
    expect_refused(Words{"r.exr", "missing.exr"} + page, "missing.exr");
    expect_refused(Words{"missing.exr", "r.exr"} + page, "missing.exr");
    expect_refused(Words{"r.exr", "room.pbrt"} + page, "room.pbrt");
    expect_refused(Words{"r.exr", "a=r.exr", "a=a.exr"} + page,
                   "second picture with the label \"a\"");
    expect_refused({"r.exr", "a.exr", "--report", "no/such/x.html"}, "no/such");
    expect_refused(Words{".", "a.exr"} + page, "is a folder");
    expect_refused(Words{"r.exr", "series=."} + page, "there is no a.json beside it");
}

TEST_F(Compare, snapshots_are_after_1_2_4_passes_and_at_the_end) {
    const Ran ran = render({"-o", "x.exr", "--passes", "6", "--snapshots", "s/deep", "--stats",
                            "x.json", "--seed", "4"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    for (const int passes : {1, 2, 4, 6}) {
        const std::string name = "s/deep/passes-00000" + std::to_string(passes);
        EXPECT_EQ(json(name + ".json")["passes"], passes);
        render({"-o", "y.exr", "--passes", std::to_string(passes), "--seed", "4"});
        EXPECT_EQ(read_text(path(name + ".exr")), read_text(path("y.exr"))) << passes;
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("s/deep")), {}), 10);
    EXPECT_LE(json("s/deep/passes-000004.json")["seconds"]["total"],
              json("x.json")["seconds"]["total"]);
    EXPECT_GT(json("s/deep/passes-000001.json")["cpu_seconds"], 0);
}

TEST_F(Compare, a_series_has_curves) {
    for (const char* seed : {"1", "2"})
        render({"-o", "x.exr", "--passes", "4", "--seed", seed, "--snapshots",
                std::string("s/") + seed});
    const Ran ran = run({"compare", "r.exr", "s", "--report", "x.html", "--json", "x.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto series = json("x.json")["pictures"][0]["series"];
    EXPECT_EQ(series["seeds"], 2);
    EXPECT_EQ(series["points"].size(), 3);
    EXPECT_NE(read_text(path("x.html")).find("Chart.js"), std::string::npos);
}

/// One that cannot be written is told when it is due, and is a fault at the end; the rest is there.
TEST_F(Compare, a_lost_snapshot_does_not_end_the_render) {
    std::filesystem::create_directories(path("s/passes-000002.json"));
    const Ran ran = render({"-o", "x.exr", "--passes", "4", "--snapshots", "s", "--stats", "x.json",
                            "--checkpoint", "x.ckpt"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_NE(ran.err.find("passes-000002.json: is a folder"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("(the render goes on)"), std::string::npos) << ran.err;
    EXPECT_EQ(json("x.json")["passes"], 4);
    for (const char* name : {"x.exr", "x.ckpt", "s/passes-000001.exr", "s/passes-000004.exr"})
        EXPECT_TRUE(exists(name)) << name;
}

TEST_F(Compare, snapshots_of_two_renders_do_not_mix) {
    render({"-o", "x.exr", "--passes", "1", "--snapshots", "s"});
    const Ran again = render({"-o", "y.exr", "--passes", "1", "--snapshots", "s"});
    EXPECT_EQ(again.code, 2);
    EXPECT_NE(again.err.find("holds pictures already"), std::string::npos);
    EXPECT_FALSE(exists("y.exr"));
    EXPECT_EQ(render({"--passes", "1", "--snapshots", "r.exr"}).code, 2);
}

}  // namespace
}  // namespace sunfleck::engine
