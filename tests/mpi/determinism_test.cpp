// One render, one hash: by 1, 2 and 3 ranks of 1, 2 and 8 threads, whole, resumed and merged.
#include "mpi/job.h"

#include <array>

namespace sunfleck::engine {
namespace {

using testing_support::JobTest;
using testing_support::operator+;
using testing_support::Ran;
using testing_support::Words;

class JobDeterminism : public JobTest {
protected:
    /// The render that all are compared with, without mpirun.
    void render_alone(const Words& words) const {
        const Ran ran = run(small(words) + outputs("alone"));
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    static Words outputs(const std::string& name) {
        return {"-o", name + ".exr", "-o", name + ".film", "--stats", name + ".json"};
    }

    /// Passes 0 to 36 at once, and after 21 passes by 1, 2 and 3 ranks.
    void expect_alike_whole_and_resumed(int ranks, const Words& words) const {
        const std::string by = std::to_string(ranks) + " ranks, ";
        const Words to_end = words + Words{"--passes", "37"};
        expect_alike(run_job(ranks, to_end), by + "whole");
        EXPECT_EQ(json("job.json")["ranks"], ranks);
        for (const int before : {1, 2, 3}) {
            const Words keep{"--passes", "21", "--checkpoint", "job.ckpt"};
            ASSERT_EQ(run_job(before, words + keep).code, 0);
            expect_alike(run_job(ranks, to_end + Words{"--resume", "job.ckpt"}),
                         by + "resumed from " + std::to_string(before));
            std::filesystem::remove(path("job.ckpt"));
        }
    }

    void expect_alike(const Ran& ran, const std::string& what) const {
        ASSERT_EQ(ran.code, 0) << what << ran.err;
        EXPECT_EQ(ran.err, "") << what;
        EXPECT_TRUE(same("alone.exr", "job.exr")) << what;
        EXPECT_TRUE(same("alone.film", "job.film")) << what;
        expect_same_counts("alone.json", "job.json");
    }
};

TEST_F(JobDeterminism, ranks_threads_and_resumes_give_one_hash) {
    const Words layers{"--aovs", "caustic,depth"};
    render_alone(layers + Words{"--passes", "37"});
    for (const int ranks : {1, 2, 3})
        for (const char* threads : {"1", "2", "8"})
            expect_alike_whole_and_resumed(
                ranks, small(layers + Words{"--nthreads", threads}) + outputs("job"));
}

TEST_F(JobDeterminism, parts_of_a_job_merge) {
    render_alone({"--passes", "20"});
    const Words first = small({"--pass-range", "0:7", "-o", "first.film"});
    const Words second = small({"--pass-range", "7:20", "-o", "second.film"});
    ASSERT_EQ(run_job(3, first).code, 0);
    ASSERT_EQ(run_job(2, second).code, 0);
    ASSERT_EQ(run({"merge", "second.film", "first.film", "-o", "sum.film"}).code, 0);
    EXPECT_TRUE(same("alone.film", "sum.film"));
}

/// Without a number of photon paths: from pass 16 on they are measured, and passes count as often
/// as they are worth.
class WeightedJob : public JobTest {
protected:
    static constexpr const char* kEnd = "20";  // of the passes

    void SetUp() override {
        JobTest::SetUp();
        ASSERT_EQ(run({"scene", "keyhole-4", "-o", "."}).code, 0);
    }

    static Words words(const Words& more) {
        return Words{"render", "keyhole-4.pbrt", "--quiet", "--resolution", "48x48"} + more;
    }

    void expect_made(const Ran& ran, const std::string& film, const std::string& what) const {
        ASSERT_EQ(ran.code, 0) << what << ran.err;
        EXPECT_TRUE(same("alone.film", film)) << what;
    }

    /// Whole, resumed from pass 8, and merged from two parts, both with passes that count twice.
    /// @param threads  three numbers, taken in interval.
    void expect_alike(int ranks, const std::array<const char*, 3>& threads) const {
        const std::string by = std::to_string(ranks) + " ranks, ";
        const auto job = [&](std::size_t interval, const Words& more) {
            return run_job(ranks, words({"--nthreads", threads.at(interval)}) + more);
        };
        expect_made(job(0, {"--passes", kEnd, "-o", "job.film"}), "job.film", by + "whole");
        const Words keep{"--passes", "8", "--checkpoint", "job.ckpt", "-o", "x.film"};
        ASSERT_EQ(job(1, keep).code, 0);
        const Words on{"--passes", kEnd, "--resume", "job.ckpt", "-o", "resumed.film"};
        expect_made(job(2, on), "resumed.film", by + "resumed");
        std::filesystem::remove(path("job.ckpt"));
        ASSERT_EQ(job(0, {"--pass-range", "0:18", "-o", "first.film"}).code, 0);
        ASSERT_EQ(job(1, {"--pass-range", std::string("18:") + kEnd, "-o", "second.film"}).code, 0);
        expect_made(run({"merge", "second.film", "first.film", "-o", "sum.film"}), "sum.film",
                    by + "merged");
    }
};

TEST_F(WeightedJob, ranks_threads_resumes_and_parts_give_one_hash) {
    const Words alone{"--passes", kEnd, "--stats", "alone.json", "-o", "alone.film"};
    ASSERT_EQ(run(words(alone)).code, 0);
    const auto epochs = json("alone.json")["epochs"];
    ASSERT_EQ(epochs.size(), 2U);
    ASSERT_GT(epochs[1]["weight"], 1);
    ASSERT_GT(epochs[1]["photons_per_pass"], epochs[0]["photons_per_pass"]);
    expect_alike(1, {"8", "1", "2"});
    expect_alike(2, {"2", "8", "1"});
    expect_alike(3, {"1", "2", "8"});
}

TEST_F(JobDeterminism, every_integrator_is_shared) {
    for (const char* integrator : {"path", "bdpt", "mlt"}) {
        const Words words{"render",   "room.pbrt", "--quiet", "--integrator",
                          integrator, "--passes",  "19"};
        ASSERT_EQ(run(words + outputs("alone")).code, 0);
        expect_alike(run_job(3, words + outputs("job")), integrator);
    }
}

TEST_F(JobDeterminism, a_target_error_ends_at_the_same_pass) {
    const Words words{"--target-error", "2%", "--passes", "5000", "--photons-per-pass", "200"};
    ASSERT_EQ(run(Words{"render", "room.pbrt", "--quiet"} + words + outputs("alone")).code, 0);
    const int passes = json("alone.json")["passes"];
    ASSERT_GT(passes, 64);
    ASSERT_LT(passes, 5000);
    for (const int ranks : {2, 3})
        expect_alike(
            run_job(ranks, Words{"render", "room.pbrt", "--quiet"} + words + outputs("job")),
            std::to_string(ranks) + " ranks");
}

/// At some pass, and what there is are all passes up to it.
TEST_F(JobDeterminism, time_ends_without_a_hole) {
    for (const char* limit : {"--time", "--cpu-time"}) {
        ASSERT_EQ(run_job(3, small({limit, "0.5"}) + outputs("job")).code, 0);
        const auto stats = json("job.json");
        EXPECT_EQ(stats["pass_ranges"].size(), 1U);
        EXPECT_GE(stats[limit == std::string("--time") ? "seconds" : "cpu_seconds"].is_object()
                      ? stats["seconds"]["total"]
                      : stats["cpu_seconds"],
                  0.5);
        render_alone({"--passes", stats["passes"].dump()});
        EXPECT_TRUE(same("alone.film", "job.film")) << limit;
    }
}

}  // namespace
}  // namespace sunfleck::engine
