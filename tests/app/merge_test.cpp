// `sunfleck merge`: parts of one render become the whole; parts of others are refused by name.
#include "app/program.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

class Merge : public ProgramTest {
protected:
    void part(const std::string& name, const std::string& range, const Words& more = {}) const {
        const Ran ran = render(Words{"-o", name, "--pass-range", range, "--quiet"} + more);
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    /// Merging a.film and b.film is refused with a line that has these words.
    void expect_refused(const std::vector<std::string>& words) const {
        const Ran ran = run({"merge", "a.film", "b.film", "-o", "x.exr"});
        EXPECT_EQ(ran.code, 2) << words[0];
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_TRUE(ran.err.starts_with("b.film: ")) << ran.err;
        for (const std::string& word : words)
            EXPECT_NE(ran.err.find(word), std::string::npos) << word << " in " << ran.err;
        EXPECT_FALSE(exists("x.exr"));
    }
};

TEST_F(Merge, writes_every_format_and_statistics) {
    part("a.film", "0:16");
    part("b.film", "16:32");
    const Ran ran = run({"merge", "-o", "x.exr", "-o", "x.png", "-o", "x.film", "a.film", "b.film",
                         "--stats", "x.json", "--exposure", "1"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(names(), "a.film b.film x.exr x.film x.json x.png");
    part("whole.exr", "0:32", {"--stats", "whole.json"});
    EXPECT_EQ(read_text(path("whole.exr")), read_text(path("x.exr")));
    const auto stats = json("x.json");
    EXPECT_EQ(stats["passes"], 32);
    EXPECT_EQ(stats["batches"], 8);  // seven of them early
    EXPECT_GT(stats["photon_paths"]["guided"], 50'000);
    EXPECT_EQ(stats["photon_paths"], json("whole.json")["photon_paths"]);
}

TEST_F(Merge, one_film_is_copied_to_the_bit) {
    part("a.film", "3:8");
    ASSERT_EQ(run({"merge", "a.film", "-o", "x.film"}).code, 0);
    EXPECT_EQ(read_text(path("x.film")), read_text(path("a.film")));
}

TEST_F(Merge, overlapping_passes) {
    part("a.film", "0:5");
    part("b.film", "4:8");
    expect_refused({"passes 4:8"});
    ASSERT_EQ(run({"merge", "a.film", "a.film", "-o", "x.exr"}).code, 2);
}

TEST_F(Merge, other_renders) {
    part("a.film", "0:2");
    const std::vector<std::pair<Words, std::vector<std::string>>> rows = {
        {{"--seed", "7"}, {"seed", "0", "7"}},
        {{"--photons-per-pass", "300"}, {"photons_per_pass", "2000", "300"}},
        {{"--direct", "photons"}, {"direct", "sampled", "photons"}},
        {{"--photon-sampler", "random"}, {"photon_sampler", "adaptive", "random"}},
        {{"--integrator", "path"}, {"integrator", "sppm", "path"}},
        {{"--max-depth", "3"}, {"max_depth", "10", "3"}},
        {{"--alpha", "0.5"}, {"alpha", "0.5"}},
        {{"--radius-pixels", "4"}, {"radius_pixels", "default", "4"}},
        {{"--radius", "0.5"}, {"radius", "0.5"}},
        {{"--resolution", "8x8"}, {"resolution", "16x12", "8x8"}},
        {{"--crop", "0,4,0,4"}, {"resolution", "16x12", "4x4"}},
        {{"--aovs", "albedo"}, {"AOVs", "albedo"}},
    };
    for (const auto& [words, named] : rows) {
        part("b.film", "2:4", words);
        expect_refused(named);
    }
}

TEST_F(Merge, windows_of_one_size_at_different_places) {
    part("a.film", "0:2", {"--crop", "0,4,0,4"});
    part("b.film", "2:4", {"--crop", "1,5,0,4"});
    expect_refused({"window", "0,0", "1,0"});
}

TEST_F(Merge, other_scenes) {
    part("a.film", "0:2");
    write_text(path("room.pbrt"), room_text("0.61"));
    part("b.film", "2:4");
    expect_refused({"scene differs"});
}

/// The same scene under another name, by another number of threads, is the same render.
TEST_F(Merge, same_scene_elsewhere) {
    part("a.film", "0:2", {"--nthreads", "1"});
    std::filesystem::create_directory(path("other"));
    write_text(path("other/copy.pbrt"), room_text("0.6"));
    ASSERT_EQ(run({"render", "other/copy.pbrt", "--photons-per-pass", "2000", "-o", "b.film",
                   "--pass-range", "2:4", "--nthreads", "2"})
                  .code,
              0);
    EXPECT_EQ(run({"merge", "a.film", "b.film", "-o", "x.exr"}).code, 0);
}

TEST_F(Merge, damaged_parts) {
    part("a.film", "0:2");
    std::string bytes = read_text(path("a.film"));
    write_text(path("b.film"), bytes.substr(0, bytes.size() - 8));
    expect_refused({"truncated or damaged"});
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_text(path("b.film"), bytes);
    expect_refused({"truncated or damaged"});
}

TEST_F(Merge, files_that_are_no_films_are_named) {
    part("a.film", "0:2");
    write_text(path("b.film"), "");
    expect_refused({"empty", "film file"});
    write_text(path("b.film"), "version https://git-lfs.github.com/spec/v1\nsize 9\n");
    expect_refused({"Git LFS", "git lfs pull"});
    std::filesystem::remove(path("b.film"));
    expect_refused({"there is no file"});
    write_text(path("B.film"), "");
    expect_refused({"B.film", "upper and lower case"});
    std::filesystem::create_directory(path("b.film"));
    expect_refused({"is a folder"});
}

}  // namespace
}  // namespace sunfleck::engine
