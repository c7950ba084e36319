// --checkpoint and --resume: a render goes on as nothing but itself.
#include "render/checkpoint.h"

#include "app/program.h"

#include <sys/resource.h>

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;
using namespace std::chrono_literals;

class Resume : public ProgramTest {
protected:
    /// Two passes of the room, kept.
    void keep(const std::string& file, const Words& words = {}) const {
        const Ran ran = render(
            Words{"-o", "kept.exr", "--quiet", "--passes", "2", "--checkpoint", file} + words);
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    /// Refused in one line that begins with the place and has these words; no file changes.
    void expect_refused(const Words& words, const std::string& place,
                        const std::vector<std::string>& named) const {
        const std::string before = names();
        const Ran ran = render(words + Words{"-o", "refused.exr"});
        EXPECT_EQ(ran.code, 2) << named[0];
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_TRUE(ran.err.starts_with(place + ": ")) << ran.err;
        for (const std::string& word : named)
            EXPECT_NE(ran.err.find(word), std::string::npos) << word << " in " << ran.err;
        EXPECT_EQ(names(), before);
    }

    std::uint64_t passes_in(const std::string& file) const {
        return read_checkpoint(path(file)).state.film.pass_count();
    }

    /// The room, for days; checkpoints after each pass.
    static Words endless(const std::string& every) {
        return {"render",    "room.pbrt",          "--quiet", "-o",           "x.exr",  "--passes",
                "100000000", "--photons-per-pass", "2000",    "--checkpoint", "x.ckpt", "--every",
                every};
    }
    void wait_for(const std::string& name) const {
        for (int i = 0; i < 6000 && !exists(name); ++i) std::this_thread::sleep_for(10ms);
        ASSERT_TRUE(exists(name));
    }
};

TEST_F(Resume, another_setting_is_refused_by_name) {
    keep("x.ckpt");
    const std::vector<std::pair<Words, std::vector<std::string>>> rows = {
        {{"--seed", "7"}, {"seed differs: 0 in the file, 7 asked for"}},
        {{"--photons-per-pass", "300"}, {"photons_per_pass=2000 in the file", "300 asked for"}},
        {{"--direct", "photons"}, {"direct=sampled in the file", "direct=photons asked for"}},
        {{"--photon-sampler", "random"}, {"photon_sampler=adaptive", "photon_sampler=random"}},
        {{"--mode", "paper"}, {"photon_sampler=adaptive", "photon_sampler=paper"}},
        {{"--integrator", "path"}, {"integrator=sppm", "integrator=path"}},
        {{"--max-depth", "3"}, {"max_depth=10", "max_depth=3"}},
        {{"--alpha", "0.5"}, {"alpha=0.66", "alpha=0.5"}},
        {{"--radius-pixels", "4"}, {"radius_pixels=default", "radius_pixels=4"}},
        {{"--radius", "0.5"}, {"radius=default", "radius=0.5"}},
        {{"--indirect-radius", "2"}, {"indirect_radius=default", "indirect_radius=2"}},
        {{"--energy-compensation", "on"}, {"energy_compensation=on"}},
        {{"--resolution", "8x8"}, {"resolution differs: 16x12 in the file, 8x8 asked for"}},
        {{"--crop", "0,4,0,4"}, {"resolution differs: 16x12 in the file, 4x4 asked for"}},
        {{"--aovs", "albedo"}, {"AOVs differs: RGB in the file, RGB albedo asked for"}},
        {{"--isa", "native"}, {"isa differs: avx2 in the file, native asked for"}},
        {{"--pass-range", "1:9"}, {"first pass differs: 0 in the file, 1 asked for"}},
        {{"--passes", "1"}, {"holds passes up to 2, and 1 are asked for"}},
    };
    for (const auto& [words, named] : rows)
        expect_refused(words + Words{"--resume", "x.ckpt"}, "x.ckpt", named);
    EXPECT_EQ(passes_in("x.ckpt"), 2U);
}

TEST_F(Resume, another_scene_is_refused_by_file) {
    const std::string scene = room_text("0.6") + "Include \"more.pbrt\"\n";
    write_text(path("room.pbrt"), scene);
    write_text(path("more.pbrt"), "# nothing\n");
    keep("x.ckpt");
    std::filesystem::create_directory(path("other"));
    write_text(path("other/more.pbrt"), "# nothing\n");
    write_text(path("other/copy.pbrt"), scene);
    EXPECT_EQ(run({"render", "other/copy.pbrt", "--photons-per-pass", "2000", "--passes", "3", "-o",
                   "kept.exr", "--resume", "x.ckpt"})
                  .code,
              0)
        << "the same files elsewhere are the same scene";
    std::filesystem::remove_all(path("other"));
    write_text(path("more.pbrt"), "# something\n");
    expect_refused({"--resume", "x.ckpt"}, "x.ckpt", {"scene file", "more.pbrt is not as it was"});
    write_text(path("room.pbrt"), room_text("0.6"));
    expect_refused({"--resume", "x.ckpt"}, "x.ckpt", {"of 2 files", "of 1"});
}

TEST_F(Resume, files_that_cannot_be_used) {
    keep("x.ckpt");
    expect_refused({"--resume", "none.ckpt"}, "none.ckpt", {"there is no file"});
    expect_refused({"--resume", "none.ckpt", "--checkpoint", "none.ckpt"}, "none.ckpt",
                   {"there is no file"});
    expect_refused({"--resume", "kept.exr"}, "kept.exr", {"an OpenEXR picture", "a checkpoint"});
    expect_refused({"--resume", "."}, ".", {"is a folder"});
    write_text(path("lfs.ckpt"), "version https://git-lfs.github.com/spec/v1\nsize 9\n");
    expect_refused({"--resume", "lfs.ckpt"}, "lfs.ckpt", {"Git LFS", "git lfs pull"});
    write_text(path("page.ckpt"), "<html><body>Sign in</body></html>");
    expect_refused({"--resume", "page.ckpt"}, "page.ckpt", {"a web page"});
    const std::string bytes = read_text(path("x.ckpt"));
    write_text(path("x.ckpt"), bytes.substr(0, bytes.size() - 8));
    expect_refused({"--resume", "x.ckpt"}, "x.ckpt", {"truncated or damaged"});
    std::string broken = bytes;
    broken[bytes.size() / 2] = static_cast<char>(broken[bytes.size() / 2] ^ 1);
    write_text(path("x.ckpt"), broken);
    expect_refused({"--resume", "x.ckpt"}, "x.ckpt", {"truncated or damaged"});
    broken = bytes;
    broken[8] = 8;
    write_text(path("x.ckpt"), broken);
    expect_refused({"--resume", "x.ckpt"}, "x.ckpt", {"version 8", "reads version 10"});
}

/// The same command once more by mistake does not cost the render.
TEST_F(Resume, a_checkpoint_is_not_replaced_unasked) {
    keep("x.ckpt");
    keep("y.ckpt");
    expect_refused({"--checkpoint", "x.ckpt"}, "x.ckpt", {"this file exists", "--resume x.ckpt"});
    expect_refused({"--checkpoint", "x.ckpt", "--resume", "y.ckpt"}, "x.ckpt",
                   {"this file exists"});
    expect_refused({"--checkpoint", "z.film", "-o", "./z.film"}, "z.film", {"written twice"});
    EXPECT_EQ(passes_in("x.ckpt"), 2U);
    EXPECT_EQ(render({"-o", "kept.exr", "--passes", "3", "--checkpoint", "./x.ckpt", "--resume",
                      path("x.ckpt")})
                  .code,
              0);
    EXPECT_EQ(passes_in("x.ckpt"), 3U);
}

TEST_F(Resume, pass_ranges_go_on_and_merge) {
    const Words keep{"-o", "b.film", "--checkpoint", "x.ckpt", "--quiet"};
    ASSERT_EQ(render(Words{"-o", "a.film", "--pass-range", "0:9"}).code, 0);
    ASSERT_EQ(render(keep + Words{"--pass-range", "9:11"}).code, 0);
    ASSERT_EQ(render(keep + Words{"--pass-range", "9:20", "--resume", "x.ckpt"}).code, 0);
    expect_refused({"--passes", "20", "--resume", "x.ckpt"}, "x.ckpt",
                   {"first pass differs: 9 in the file, 0 asked for"});
    ASSERT_EQ(run({"merge", "b.film", "a.film", "-o", "x.exr"}).code, 0);
    ASSERT_EQ(render({"-o", "whole.exr", "--passes", "20"}).code, 0);
    EXPECT_TRUE(read_text(path("x.exr")) == read_text(path("whole.exr")));
}

/// Errors are asked for where batches end, by a render that goes on as well: at pass 7 this one
/// has an error that it had not at 6, for the bias of its discs, much of it at edges, is that of
/// all passes.
TEST_F(Resume, a_target_is_reached_where_it_is_in_one_go) {
    const Words of_discs{"--quiet", "--indirect", "photons", "--edges", "off"};
    const auto error_at = [&](const std::string& passes) -> double {
        const Ran ran =
            render(of_discs + Words{"-o", "x.exr", "--stats", "x.json", "--passes", passes});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json("x.json")["image"]["target_error"];
    };
    const double at_6 = error_at("6");
    const double at_7 = error_at("7");
    ASSERT_LT(at_7, at_6) << "take another pass";
    const Words words =
        of_discs + Words{"-o",     "x.exr",          "--stats",
                         "x.json", "--target-error", std::to_string((at_6 + at_7) / 2)};
    ASSERT_EQ(render(words).code, 0);
    const int in_one_go = json("x.json")["passes"];
    EXPECT_EQ(in_one_go, 8);
    ASSERT_EQ(
        render(of_discs + Words{"-o", "x.exr", "--passes", "7", "--checkpoint", "x.ckpt"}).code, 0);
    ASSERT_EQ(render(words + Words{"--resume", "x.ckpt"}).code, 0);
    EXPECT_EQ(json("x.json")["passes"], in_one_go);
}

/// Seconds add up, and a time limit counts them all.
TEST_F(Resume, time_already_spent_counts) {
    const Words words{"-o",     "x.exr",   "--stats",          "x.json", "--checkpoint",
                      "x.ckpt", "--quiet", "--photon-sampler", "uniform"};  // no time to learn
    ASSERT_EQ(render(words + Words{"--time", "0.3"}).code, 0);
    const auto first = json("x.json");
    const double spent = read_checkpoint(path("x.ckpt")).state.total_seconds;
    EXPECT_GE(spent, 0.3);
    ASSERT_EQ(render(words + Words{"--time", "0.3", "--resume", "x.ckpt"}).code, 0);
    auto again = json("x.json");
    EXPECT_EQ(again["passes"], first["passes"]) << "no pass more";
    EXPECT_GE(again["seconds"]["total"], spent);
    EXPECT_EQ(again["seconds"]["photon"], first["seconds"]["photon"]);
    const double limit = read_checkpoint(path("x.ckpt")).state.total_seconds + 0.2;
    ASSERT_EQ(render(words + Words{"--time", std::to_string(limit), "--resume", "x.ckpt"}).code, 0);
    EXPECT_GT(json("x.json")["passes"], first["passes"]);
    EXPECT_GE(read_checkpoint(path("x.ckpt")).state.total_seconds, limit - 1e-6);
}

TEST_F(Resume, after_an_interrupt) {
    const Words unlearned{"--photon-sampler", "uniform"};  // its first pass begins at once
    Process process(path(""), endless("1h") + unlearned);
    ASSERT_TRUE(wait_for_render());
    std::this_thread::sleep_for(100ms);
    process.send(SIGINT);
    EXPECT_EQ(process.wait().code, 130);
    EXPECT_EQ(names(), "x.ckpt x.exr");
    const std::uint64_t held = passes_in("x.ckpt");
    EXPECT_GE(held, 1U);
    const std::string more = std::to_string(held + 3);
    const Words again = unlearned + Words{"--passes", more};
    ASSERT_EQ(render(again + Words{"-o", "x.exr", "--resume", "x.ckpt"}).code, 0);
    ASSERT_EQ(render(again + Words{"-o", "whole.exr"}).code, 0);
    EXPECT_TRUE(read_text(path("x.exr")) == read_text(path("whole.exr")));
}

/// Killed when a part of a file is seen, again if it was whole before the kill came.
TEST_F(Resume, a_kill_while_writing_leaves_the_former_one) {
    const auto writes = [&] { return is_writing(); };
    for (int i = 0; i < 1000 && !writes(); ++i) {
        const bool again = exists("x.ckpt");
        Process process(path(""),
                        endless("0.000001") + (again ? Words{"--resume", "x.ckpt"} : Words{}));
        wait_for("x.ckpt");
        const auto end = std::chrono::steady_clock::now() + 60s;
        while (!writes() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        process.send(SIGKILL);
        ASSERT_EQ(process.wait().code, 1000 + SIGKILL);
        ASSERT_LT(std::chrono::steady_clock::now(), end) << "it writes no checkpoint";
    }
    ASSERT_TRUE(writes()) << "it died while writing";
    const std::uint64_t held = passes_in("x.ckpt");
    EXPECT_GE(held, 1U);
    const std::string more = std::to_string(held + 3);
    const Words words{"-o", "x.exr", "--passes", more, "--quiet"};
    ASSERT_EQ(render(words + Words{"--resume", "x.ckpt", "--checkpoint", "x.ckpt"}).code, 0);
    EXPECT_EQ(names(), "x.ckpt x.exr") << "what the killed one left is gone";
    ASSERT_EQ(render(words + Words{"-o", "whole.exr"}).code, 0);
    EXPECT_TRUE(read_text(path("x.exr")) == read_text(path("whole.exr")));
}

/// The disk is full for checkpoints, not for the small picture: the render goes on to its end, says
/// so once, and ends with code 1.
TEST_F(Resume, a_full_disk_is_said_and_does_not_end_the_render) {
    keep("x.ckpt");
    Words words = endless("0.000001") + Words{"--resume", "x.ckpt"};
    words.erase(words.begin() + 2);  // --quiet
    Process process(path(""), words);
    ASSERT_TRUE(wait_for_render());
    const rlimit small{4000, 4000};
    ASSERT_EQ(::prlimit(process.id(), RLIMIT_FSIZE, &small, nullptr), 0);
    std::this_thread::sleep_for(100ms);
    process.send(SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.code, 1);
    const std::string fault =
        "x.ckpt: cannot write: File too large; make room on the disk, or write to another one";
    const std::string warning = "warning: " + fault + " (the render goes on)\n";
    const std::size_t first = ran.err.find(warning);
    EXPECT_NE(first, std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.rfind(warning), first) << "said once: " << ran.err;
    EXPECT_TRUE(ran.err.ends_with("\n" + fault + "\n")) << ran.err;
    EXPECT_EQ(names(), "kept.exr x.ckpt x.exr");
    EXPECT_GE(passes_in("x.ckpt"), 2U);
}

}  // namespace
}  // namespace sunfleck::engine
