// Where pictures and statistics go: told, never lost, never one over another.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

class Outputs : public ProgramTest {
protected:
    /// One line with this text, exit code 2, and nothing written.
    void expect_refused(const Words& words, const std::string& text) const {
        const std::string before = names();
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 2) << text;
        EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_EQ(names(), before);
    }
};

/// A folder that goes away under a render: the other files are written, and the fault is told.
TEST_F(Outputs, of_which_one_cannot_be_written_leave_the_others) {
    std::filesystem::create_directory(path("away"));
    Process process(
        path(""), {"render", "room.pbrt", "--quiet", "-o", "away/x.png", "-o", "x.film", "--stats",
                   "x.json", "--passes", "1000000", "--photon-sampler", "uniform"});
    ASSERT_TRUE(wait_for_render());
    std::filesystem::remove_all(path("away"));
    process.send(SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 1) << "it could be written when the render began";
    EXPECT_TRUE(ran.err.starts_with("away/x.png: ")) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(names(), "x.film x.json");
    EXPECT_EQ(run({"merge", "x.film", "-o", "x.png"}).code, 0);
    EXPECT_EQ(run({"merge", "x.film", "-o", "away/y.png"}).code, 2);
}

/// More than a limit on the size of files: a fault as any other.
TEST_F(Outputs, that_grow_too_large_are_faults) {
    write_text(path("limited"), "#!/bin/sh\nulimit -f 1\nexec " SUNFLECK_PROGRAM " \"$@\"\n");
    std::filesystem::permissions(path("limited"), std::filesystem::perms::owner_all);
    const Ran ran = Process(path(""),
                            {"render", "room.pbrt", "--quiet", "-o", "x.exr", "--passes", "1",
                             "--resolution", "64x64"},
                            path("limited"))
                        .wait();
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.err.starts_with("x.exr: cannot write: File too large")) << ran.err;
    EXPECT_EQ(names(), "limited");
}

TEST_F(Outputs, are_files_apart) {
    const std::string text = "is to be written twice; give each file a name of its own";
    expect_refused({"render", "room.pbrt", "-o", "x.exr", "--stats", "./x.exr"}, "x.exr: " + text);
    expect_refused({"render", "room.pbrt", "-o", "x.png", "-o", "x.exr", "-o", "x.png"},
                   "x.png: " + text);
    expect_refused({"render", "room.pbrt", "--stats", "named.exr"}, "named.exr: " + text);
    expect_refused({"render", "room.pbrt", "-o", "x.exr", "--stats", "x", "--checkpoint", "x"},
                   text);
    expect_refused({"compare", "x.exr", "y.exr", "--report", "z", "--json", "z"}, text);
    expect_refused({"relight", "x.exr", "sun=1", "-o", "y.png", "-o", "y.png"}, text);
}

/// By another spelling, a symbolic link, a hard link: one file.
TEST_F(Outputs, replace_no_input) {
    namespace fs = std::filesystem;
    ASSERT_EQ(render({"--passes", "1", "-o", "x.exr", "-o", "x.film", "--quiet"}).code, 0);
    write_text(path("part.pbrt"), "# nothing\n");
    write_text(path("all.pbrt"), "Include \"part.pbrt\"\n" + room_text("0.6"));
    fs::create_symlink("x.film", path("soft.film"));
    fs::create_hard_link(path("x.film"), path("hard.film"));
    fs::create_hard_link(path("part.pbrt"), path("part.json"));
    fs::create_directory(path("sub"));
    const std::string text = ", which the command reads; give each file a name of its own";
    const auto refused = [&](const Words& words, const std::string& file) {
        expect_refused(words, "would replace " + file + text);
    };
    refused({"render", "room.pbrt", "-o", "y.exr", "--stats", "room.pbrt"}, "room.pbrt");
    refused({"render", "all.pbrt", "-o", "y.exr", "--stats", "part.json"}, "part.pbrt");
    refused({"render", "all.pbrt", "-o", "y.exr", "--checkpoint", "y", "--resume", "x.film",
             "--stats", "sub/../x.film"},
            "x.film");
    refused({"merge", "x.film", "-o", "soft.film"}, "x.film");
    refused({"merge", "soft.film", "-o", "hard.film"}, "soft.film");
    refused({"merge", "x.film", "-o", "y.exr", "--stats", "sub/../x.film"}, "x.film");
    refused({"relight", "x.exr", "sun=1", "-o", "./x.exr"}, "x.exr");
    refused({"compare", "x.exr", "x.exr", "--json", "x.exr"}, "x.exr");
    refused({"compare", "x.exr", "x.exr", "--report", path("x.exr")}, "x.exr");
}

/// The folder of snapshots must not hold a file of the render under a snapshot's name.
TEST_F(Outputs, are_no_snapshots) {
    std::filesystem::create_directory(path("shots"));
    expect_refused({"render", "room.pbrt", "-o", "shots/passes-000001.exr", "--snapshots", "shots"},
                   "would be replaced by a snapshot in shots");
    std::filesystem::create_symlink("../room.pbrt", path("shots/passes-000002.json"));
    expect_refused({"render", "room.pbrt", "-o", "x.exr", "--snapshots", "./shots"},
                   "room.pbrt: would be replaced by a snapshot in ./shots");
}

/// A link to a file that is not there yet is followed, as one to a file that is.
TEST_F(Outputs, may_be_links_to_files_to_be) {
    std::filesystem::create_symlink("y.exr", path("soft.exr"));
    std::filesystem::create_symlink("loop.exr", path("loop.exr"));
    expect_refused({"render", "room.pbrt", "-o", "y.exr", "-o", "soft.exr"}, "written twice");
    expect_refused({"render", "room.pbrt", "-o", "loop.exr"}, "leads back to itself");
    EXPECT_EQ(render({"-o", "soft.exr", "--passes", "1", "--quiet"}).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(path("soft.exr")));
    EXPECT_TRUE(exists("y.exr"));
}

/// For as long as the first render lives; and a kill leaves nothing that is in the way.
TEST_F(Outputs, are_of_one_render_at_a_time) {
    std::filesystem::create_symlink("x.png", path("soft.png"));
    Process process(path(""), {"render", "room.pbrt", "--quiet", "-o", "x.png", "--checkpoint",
                               "x.ckpt", "--every", "0.01", "--passes", "1000000"});
    for (int i = 0; i < 6000 && !exists("x.ckpt"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::string text = "is being written by process " + std::to_string(process.id());
    const auto refused = [&](const Words& words) {
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, 2);
        EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
    };
    refused({"render", "room.pbrt", "--passes", "1", "-o", "x.png"});
    refused({"render", "room.pbrt", "--passes", "1", "-o", "y.png", "--stats", "soft.png"});
    refused({"render", "room.pbrt", "--quiet", "-o", "y.png", "--checkpoint", "x.ckpt", "--resume",
             "x.ckpt"});
    process.send(SIGKILL);
    process.wait();
    EXPECT_EQ(run({"render", "room.pbrt", "--quiet", "-o", "x.png", "--checkpoint", "x.ckpt",
                   "--resume", "x.ckpt", "--time", "0.01"})
                  .code,
              0);
    EXPECT_EQ(names(), "soft.png x.ckpt x.png");
}

/// A scene of ours that someone has edited is not lost.
TEST_F(Outputs, of_scene_replace_no_file_that_differs) {
    ASSERT_EQ(run({"scene", "cornell", "-o", "s"}).code, 0);
    EXPECT_EQ(run({"scene", "cornell", "-o", "s"}).code, 0) << "the same bytes";
    const std::string ours = read_text(path("s/cornell.pbrt"));
    write_text(path("s/cornell.pbrt"), "edited");
    expect_refused({"scene", "cornell", "-o", "s"}, "--force");
    EXPECT_EQ(read_text(path("s/cornell.pbrt")), "edited");
    EXPECT_EQ(run({"scene", "cornell", "-o", "s", "--force"}).code, 0);
    EXPECT_EQ(read_text(path("s/cornell.pbrt")), ours);
}

TEST_F(Outputs, hold_the_layers_that_are_asked_for) {
    for (const Words& aov : {Words{"--aovs", "depth"}, Words{"--light-group", "each"}})
        expect_refused({"render", "room.pbrt", "-o", "x.png", aov[0], aov[1]},
                       aov[0] + ": a .png or .jpg holds no AOVs; add an output that does");
    expect_refused({"render", "room.pbrt", "-o", "x.PNG", "--aovs", "depth"}, "holds no AOVs");
    EXPECT_EQ(render({"-o", "x.png", "-o", "x.film", "--passes", "1", "--aovs", "depth"}).code, 0);
}

TEST_F(Outputs, have_endings_that_are_named) {
    const std::string text = "unknown output format; end it in .film, .exr, .png, .jpg or .jpeg";
    expect_refused({"render", "room.pbrt", "-o", "x.tif"}, "x.tif: " + text);
    expect_refused({"merge", "x.film", "-o", "x"}, "x: " + text);
}

/// What is chosen because nothing is said, on standard error; nothing of it where all is said.
TEST_F(Outputs, and_other_defaults_are_told) {
    const Ran named = render({"--passes", "1"});
    EXPECT_TRUE(named.err.starts_with("no output given; writing named.exr (-o)\n")) << named.err;
    const Ran all_said = render({"--passes", "1", "-o", "x.exr"});
    EXPECT_TRUE(all_said.err.starts_with("x.exr: 1 pass, ")) << all_said.err;
    EXPECT_EQ(std::count(all_said.err.begin(), all_said.err.end(), '\n'), 1);
    const Ran endless = render({"-o", "x.exr", "--target-error-of", "noise", "--resolution", "8x8",
                                "--photons-per-pass", "10000"});
    EXPECT_EQ(endless.code, 0);
    EXPECT_TRUE(
        endless.err.starts_with("no limit given; ending at an error of 2% or after 10 "
                                "minutes (--target-error, --time)\n"))
        << endless.err;
    const std::string known = "% (95% of blocks)\n";
    EXPECT_TRUE(endless.err.ends_with(known)) << endless.err;
}

TEST_F(Outputs, need_a_scene_that_can_be_read) {
    write_text(path("lamp.GLB"), "glTF");
    expect_refused({"render", "lamp.GLB", "-o", "x.exr"},
                   "lamp.GLB: ends in its head; export or copy the file again");
    expect_refused({"info", "."}, ".: \".\" is a folder; name a file in it");
}

TEST_F(Outputs, refusals_say_where_to_read_on) {
    expect_refused({"compare", "a.exr"}, "see sunfleck compare --help");
    expect_refused({"render", "room.pbrt", "--pases", "3"}, "see sunfleck render --help");
    expect_refused({"render", "room.pbrt", "--passes", "many"},
                   "\"many\" is no whole number from 1 to 1073741824");
    expect_refused({}, "see sunfleck --help");
}

}  // namespace
}  // namespace sunfleck::engine
