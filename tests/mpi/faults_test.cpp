// What goes wrong with a job: killed ranks, signals, bad input on all ranks or on one.
#include "mpi/job.h"
#include "render/checkpoint.h"

namespace sunfleck::engine {
namespace {

using testing_support::JobTest;
using testing_support::operator+;
using testing_support::Process;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;
using namespace std::chrono_literals;

class JobFaults : public JobTest {
protected:
    static Words endless(const Words& more) {
        return small({"--passes", "100000000", "-o", "x.exr", "--checkpoint", "x.ckpt", "--every",
                      "0.000001"}) +
               more;
    }

    void wait_for_checkpoint() const {
        for (int i = 0; i < 6000 && !exists("x.ckpt"); ++i) std::this_thread::sleep_for(10ms);
        ASSERT_TRUE(exists("x.ckpt"));
    }

    /// The processes that one started.
    static std::vector<::pid_t> children(::pid_t of) {
        const std::string id = std::to_string(of);
        std::istringstream list(read_text("/proc/" + id + "/task/" + id + "/children"));
        std::vector<::pid_t> all;
        for (::pid_t child = 0; list >> child;) all.push_back(child);
        return all;
    }

    /// Is a process gone, or nothing but an exit code that nobody has asked for? Soon, at least.
    static bool ends(::pid_t id) {
        for (int i = 0; i < 1000; ++i, std::this_thread::sleep_for(10ms)) {
            const std::string stat = read_text("/proc/" + std::to_string(id) + "/stat");
            if (stat.empty() || stat.find(") Z") != std::string::npos) return true;
        }
        return false;
    }

    /// The checkpoint is whole, and goes on to the bytes of a render that was left alone.
    void expect_goes_on(int ranks) const {
        const std::uint64_t held = read_checkpoint(path("x.ckpt")).state.film.pass_count();
        EXPECT_GE(held, 1U);
        const Words more{"--passes", std::to_string(held + 5)};
        ASSERT_EQ(run_job(ranks, small(more) + Words{"-o", "x.film", "--resume", "x.ckpt"}).code,
                  0);
        ASSERT_EQ(run(small(more) + Words{"-o", "alone.film"}).code, 0);
        EXPECT_TRUE(same("alone.film", "x.film"));
    }

    /// One line, once, and exit code 2.
    void expect_refused(int ranks, const Words& words, const std::string& line) const {
        const Ran ran = run_job(ranks, words);
        EXPECT_EQ(ran.code, 2) << ran.err;
        EXPECT_EQ(count(ran.err, line), 1) << ran.err;
    }
};

TEST_F(JobFaults, a_killed_rank_ends_the_job_and_leaves_the_checkpoint) {
    for (const std::size_t which : {0U, 2U}) {
        Process job = start(3, endless({}));
        wait_for_checkpoint();
        std::this_thread::sleep_for(100ms);
        const auto ranks = children(job.id());
        ASSERT_EQ(ranks.size(), 3U);
        ::kill(ranks[which], SIGKILL);
        EXPECT_NE(job.wait().code, 0);
        for (const ::pid_t rank : ranks) EXPECT_TRUE(ends(rank)) << "no rank is left";
        EXPECT_FALSE(exists("x.exr"));
        expect_goes_on(2);
        for (const auto& entry : std::filesystem::directory_iterator(path("")))
            if (entry.path().extension() != ".pbrt") std::filesystem::remove(entry.path());
    }
}

/// mpirun hands Ctrl-C on as SIGTERM, and waits before it kills.
TEST_F(JobFaults, an_interrupt_writes_the_picture) {
    Process job = start(3, endless({}));
    wait_for_checkpoint();
    job.send(SIGINT);
    EXPECT_NE(job.wait().code, 0) << "mpirun's own: 1";
    EXPECT_TRUE(exists("x.exr"));
    expect_goes_on(3);
}

TEST_F(JobFaults, one_signal_to_one_rank_ends_all) {
    Process job = start(3, endless({}));
    wait_for_checkpoint();
    const auto ranks = children(job.id());
    ASSERT_EQ(ranks.size(), 3U);
    ::kill(ranks[1], SIGTERM);
    EXPECT_EQ(job.wait().code, 130);
    EXPECT_TRUE(exists("x.exr"));
    expect_goes_on(1);
}

TEST_F(JobFaults, a_bad_scene_is_said_once) {
    write_text(path("bad.pbrt"), "WorldBegin\nShape \"globe\"\n");
    expect_refused(3, {"render", "bad.pbrt", "-o", "x.exr"}, "bad.pbrt:2:1: ");
    expect_refused(3, small({"--passes", "2", "-o", "x.exr", "--frob"}), "\"--frob\"");
    expect_refused(3, small({"--passes", "2", "-o", "none/x.exr"}), "none/x.exr: ");
    expect_refused(3, small({"--passes", "2", "-o", "x.exr", "--resume", "none.ckpt"}),
                   "none.ckpt: ");
    EXPECT_EQ(names(), "");
}

TEST_F(JobFaults, the_sampler_paper_is_refused) {
    expect_refused(2, small({"--mode", "paper", "--passes", "2", "-o", "x.exr"}),
                   "--photon-sampler: paper");
    EXPECT_EQ(run_job(1, small({"--mode", "paper", "--passes", "2", "-o", "x.exr"})).code, 0);
}

/// Ranks on machines whose files are not the same: in folders of their own here.
TEST_F(JobFaults, a_rank_with_another_scene_or_none_is_named) {
    std::filesystem::create_directory(path("other"));
    const Words words = small({"--passes", "2", "-o", "x.exr"});
    const Words both = job_words(1, words) +
                       Words{":", "-n", "1", "--wdir", path("other"), SUNFLECK_PROGRAM} + words;
    const auto run_both = [&] { return Process(path(""), both, SUNFLECK_MPIRUN).wait(); };
    const Ran none = run_both();
    EXPECT_EQ(none.code, 2) << none.err;
    EXPECT_EQ(count(none.err, "rank 1: room.pbrt: "), 1) << none.err;
    write_text(path("other/room.pbrt"), room_text("0.7"));
    const Ran another = run_both();
    EXPECT_EQ(another.code, 2) << another.err;
    EXPECT_EQ(count(another.err, "rank 1: render: the scene is not that of rank 0"), 1)
        << another.err;
    EXPECT_EQ(names(), "other");
    write_text(path("other/room.pbrt"), room_text("0.6"));
    EXPECT_EQ(run_both().code, 0);
}

}  // namespace
}  // namespace sunfleck::engine
