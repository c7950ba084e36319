// A render that goes on has the bytes of one that was never stopped.
#include "app/program.h"
#include "render/checkpoint.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;

class ResumeSlow : public ProgramTest {
protected:
    /// All that a render writes; of the statistics all that is neither time nor of the run.
    struct Files {
        std::string exr, png, film;
        nlohmann::json stats;
        friend bool operator==(const Files&, const Files&) = default;
    };

    Files files_of(const Words& words) const {
        const Ran ran = run(words + Words{"-o", "x.exr", "-o", "x.png", "-o", "x.film", "--stats",
                                          "x.json", "--quiet"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        nlohmann::json stats = json("x.json");
        for (const char* name : {"seconds", "cpu_seconds", "command", "threads"}) stats.erase(name);
        return {read_text(path("x.exr")), read_text(path("x.png")), read_text(path("x.film")),
                stats};
    }
};

/// Every sampler and integrator, stopped in two epochs of what adaptive sampling learns.
TEST_F(ResumeSlow, has_the_bytes_of_a_whole_render) {
    ASSERT_EQ(run({"scene", "cognac-4", "-o", "."}).code, 0);
    const std::vector<Words> ways = {
        {"--photon-sampler", "adaptive", "--indirect", "photons", "--photons-per-pass", "6000",
         "--aovs", "caustic,depth"},
        {"--indirect", "auto", "--photons-per-pass", "6000"},
        {"--indirect", "sampled", "--photons-per-pass", "6000"},
        {"--photon-sampler", "uniform", "--photons-per-pass", "2000"},
        {"--photon-sampler", "random", "--photons-per-pass", "2000"},
        {"--photon-sampler", "paper", "--photons-per-pass", "2000"},
        {"--integrator", "path"},
        {"--integrator", "light", "--photons-per-pass", "2000"},
    };
    for (const Words& way : ways) {
        const Words words =
            Words{"render", "cognac-4.pbrt", "--resolution", "12x10", "--seed", "3"} + way;
        const Words keep{"--checkpoint", "x.ckpt"};
        const Words resume{"--resume", "x.ckpt"};
        const Files whole = files_of(words + Words{"--passes", "21", "--nthreads", "1"});
        files_of(words + keep + Words{"--passes", "5", "--nthreads", "8"});
        EXPECT_FALSE(files_of(words + keep + resume + Words{"--passes", "18", "--nthreads", "2"}) ==
                     whole);
        EXPECT_EQ(read_checkpoint(path("x.ckpt")).state.film.pass_count(), 18U);
        for (const char* threads : {"1", "8"}) {
            const Files files =
                files_of(words + resume + Words{"--passes", "21", "--nthreads", threads});
            EXPECT_TRUE(files == whole) << way[1] << " threads " << threads;
            EXPECT_EQ(files.stats, whole.stats) << way[1];
        }
        if (way[1] == "adaptive") {
            EXPECT_GT(whole.stats["splitting"]["levels"], 0) << "nothing to learn";
        }
        std::filesystem::remove(path("x.ckpt"));
    }
}

}  // namespace
}  // namespace sunfleck::engine
