// `render --snapshots`: the newest picture under a name that stays.
#include "app/program.h"

#include <sys/stat.h>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;
using testing_support::operator+;

class LatestSnapshot : public ProgramTest {
protected:
    void expect_refused(const Words& words, const std::string& text) const {
        const Ran ran = render(words + Words{"--passes", "1", "--quiet"});
        EXPECT_EQ(ran.code, 2) << text;
        EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
    }
};

TEST_F(LatestSnapshot, is_the_last_picture_as_it_is_and_as_the_screen_shows_it) {
    const Words exposed{"--exposure", "2.5", "--passes", "6"};
    ASSERT_EQ(render(exposed + Words{"-o", "x.exr", "-o", "x.png", "--snapshots", "s"}).code, 0);
    EXPECT_EQ(read_text(path("s/latest.exr")), read_text(path("s/passes-000006.exr")));
    EXPECT_EQ(read_text(path("s/latest.exr")), read_text(path("x.exr")));
    EXPECT_EQ(read_text(path("s/latest.png")), read_text(path("x.png")));
}

/// The picture that is there is another inode: a reader of the old one reads on.
TEST_F(LatestSnapshot, replaces_the_one_before_whole) {
    const auto inode = [&] {
        struct ::stat file {};
        ::stat(path("s/latest.exr").c_str(), &file);
        return file.st_ino;
    };
    ASSERT_EQ(
        render({"-o", "x.exr", "--passes", "2", "--snapshots", "s", "--checkpoint", "c"}).code, 0);
    const std::string before = read_text(path("s/latest.exr"));
    std::filesystem::create_hard_link(path("s/latest.exr"), path("kept"));
    const auto old = inode();
    ASSERT_EQ(render({"-o", "x.exr", "--passes", "5", "--snapshots", "s", "--resume", "c"}).code,
              0);
    EXPECT_EQ(read_text(path("s/latest.exr")), read_text(path("s/passes-000005.exr")));
    EXPECT_NE(inode(), old);
    EXPECT_EQ(read_text(path("kept")), before);
    EXPECT_EQ(read_text(path("s/passes-000002.exr")), before);
}

TEST_F(LatestSnapshot, replaces_nothing_that_is_finished) {
    std::filesystem::create_directories(path("s"));
    expect_refused({"-o", "s/latest.exr", "--snapshots", "s"}, "would be replaced by a snapshot");
    expect_refused({"-o", "s/latest.png", "--snapshots", "s"}, "would be replaced by a snapshot");
    for (const char* name : {"latest.exr", "latest.png"}) {
        write_text(path("s/" + std::string(name)), "finished");
        expect_refused({"-o", "x.exr", "--snapshots", "s"}, "holds pictures already");
        EXPECT_EQ(read_text(path("s/" + std::string(name))), "finished");
        std::filesystem::remove(path("s/" + std::string(name)));
    }
    ASSERT_EQ(
        render({"-o", "x.exr", "--passes", "1", "--snapshots", "s", "--checkpoint", "c"}).code, 0);
    std::filesystem::rename(path("s/latest.png"), path("finished.png"));
    std::filesystem::create_symlink("../finished.png", path("s/latest.png"));
    const std::string finished = read_text(path("finished.png"));
    expect_refused({"-o", "x.exr", "--snapshots", "s", "--resume", "c"}, "s/latest.png: is a link");
    EXPECT_EQ(read_text(path("finished.png")), finished);
}

/// Only the numbered pictures have statistics, and a curve's points.
TEST_F(LatestSnapshot, is_no_point_of_a_series) {
    for (const char* seed : {"1", "2"})
        render({"-o", "x.exr", "--passes", "2", "--seed", seed, "--snapshots",
                std::string("s/") + seed});
    render({"-o", "r.exr", "--passes", "2", "--seed", "3"});
    const Ran ran = run({"compare", "r.exr", "s", "--json", "x.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(json("x.json")["pictures"][0]["series"]["points"].size(), 2);
}

}  // namespace
}  // namespace sunfleck::engine
