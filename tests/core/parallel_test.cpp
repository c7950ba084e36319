// Tests core/parallel.h: each index once, exceptions, limits, and alike arithmetic on all threads.
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

/// The threads that a loop is run by, when its tasks wait for `hoped` of them (ten seconds at
/// most).
std::size_t threads_seen(std::size_t hoped) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    std::mutex guard;
    std::set<std::thread::id> seen;
    const auto all_here = [&] {
        const std::lock_guard lock(guard);
        seen.insert(std::this_thread::get_id());
        return seen.size() >= hoped;
    };
    parallel_for(256, [&](std::size_t) {
        while (!all_here() && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    return seen.size();
}

TEST(ParallelFor, calls_each_index_once) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U, 100000U}) {
        std::vector<std::atomic<int>> calls(count);
        parallel_for(count, [&](std::size_t i) { ++calls.at(i); });
        for (const std::atomic<int>& n : calls) ASSERT_EQ(n, 1) << "of " << count;
    }
}

TEST(ParallelFor, what_tasks_wrote_is_seen_after_it) {
    const ThreadLimit limit(8);
    std::vector<std::size_t> square(10000);
    parallel_for(square.size(), [&](std::size_t i) { square[i] = i * i; });
    for (std::size_t i = 0; i < square.size(); ++i) ASSERT_EQ(square[i], i * i);
}

TEST(ParallelFor, an_exception_reaches_the_caller) {
    std::string caught;
    try {
        parallel_for(10000, [](std::size_t i) {
            if (i == 4321) throw std::runtime_error("task 4321");
        });
    } catch (const std::runtime_error& fault) {
        caught = fault.what();
    }
    EXPECT_EQ(caught, "task 4321");

    std::atomic<int> calls = 0;
    parallel_for(100, [&](std::size_t) { ++calls; });  // and the next loop is whole
    EXPECT_EQ(calls, 100);
}

TEST(ParallelFor, loops_may_be_nested) {
    const ThreadLimit limit(4);
    std::atomic<int> calls = 0;
    parallel_for(20, [&](std::size_t) { parallel_for(30, [&](std::size_t) { ++calls; }); });
    EXPECT_EQ(calls, 600);
}

void expect_cover(std::size_t count, std::size_t block) {
    std::vector<std::atomic<int>> calls(count);
    std::atomic<std::size_t> blocks = 0;
    std::atomic<int> misfits = 0;
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        ++blocks;
        const bool fits = begin % block == 0 && (end == count || end == begin + block);
        if (!fits || begin >= end) ++misfits;
        for (std::size_t i = begin; i < end; ++i) ++calls.at(i);
    });
    EXPECT_EQ(blocks, (count + block - 1) / block);
    EXPECT_EQ(misfits, 0);
    for (const std::atomic<int>& n : calls) ASSERT_EQ(n, 1);
}

TEST(ParallelBlocks, cover_the_range_in_blocks_of_one_size) {
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 1000U})
        for (const std::size_t block : {1U, 8U, 64U, 5000U}) expect_cover(count, block);
}

TEST(BlockOfAThread, is_the_share_of_each_rounded_up_but_not_small) {
    const ThreadLimit three(3);
    EXPECT_EQ(block_of_a_thread(10, 1), 4U);
    EXPECT_EQ(block_of_a_thread(9, 1), 3U);
    EXPECT_EQ(block_of_a_thread(10, 7), 7U);
    EXPECT_EQ(block_of_a_thread(0, 5), 5U);
}

TEST(ParallelBlocks, a_block_may_be_as_large_as_a_number_can_be) {
    std::pair<std::size_t, std::size_t> got;
    parallel_blocks(7, std::numeric_limits<std::size_t>::max(),
                    [&](std::size_t begin, std::size_t end) {
                        got = {begin, end};
                    });
    EXPECT_EQ(got, (std::pair<std::size_t, std::size_t>{0, 7}));
}

TEST(ThreadLimit, gives_the_number_of_threads_asked_for) {
    for (const std::size_t count : {1U, 2U, 5U}) {
        const ThreadLimit limit(count);
        EXPECT_EQ(thread_count(), count);
        EXPECT_EQ(threads_seen(count), count);
    }
}

/// So it is for loops within tasks, on whatever thread they run.
TEST(RunUnless, cuts_loops_short_also_those_within) {
    const ThreadLimit limit(4);
    std::atomic<bool> over = false;
    std::atomic<int> done = 0;
    const auto is_over = [&] { return over.load(); };
    const auto work = [&] {
        parallel_for(100, [&](std::size_t) {
            parallel_for(100, [&](std::size_t) {
                if (++done == 50) over = true;
            });
        });
    };
    EXPECT_FALSE(run_unless(is_over, work));
    EXPECT_GE(done, 50);
    EXPECT_LT(done, 1000);
    over = false;
    done = 100;
    EXPECT_TRUE(run_unless(is_over, work));
    EXPECT_EQ(done, 10'100);
    over = true;
    work();  // asks nobody
    EXPECT_EQ(done, 20'100);
    EXPECT_TRUE(run_unless({}, work));
}

TEST(ThreadPool, has_no_more_threads_than_asked_for_or_than_cores) {
    std::size_t threads = 0;
    const auto count = [&] { threads = thread_count(); };
    ThreadPool(1).run(count);
    EXPECT_EQ(threads, 1U);
    const std::size_t cores = std::thread::hardware_concurrency();
    for (const std::size_t many : {std::size_t{0}, std::size_t{5000000000}, ~std::size_t{0}}) {
        ThreadPool(many).run(count);
        EXPECT_GE(threads, 1U) << many;
        EXPECT_LE(threads, cores) << many;
    }
}

TEST(ThreadLimit, ends_with_its_life) {
    const std::size_t before = thread_count();
    {
        const ThreadLimit outer(3);
        {
            const ThreadLimit inner(1);
            EXPECT_EQ(thread_count(), 1U);
        }
        EXPECT_EQ(thread_count(), 3U);
        const ThreadLimit more(64);
        EXPECT_EQ(thread_count(), 3U);
    }
    EXPECT_EQ(thread_count(), before);
}

TEST(ThreadLimit, zero_changes_nothing) {
    const ThreadLimit outer(3);
    const ThreadLimit none(0);
    EXPECT_EQ(thread_count(), 3U);
}

#if defined(__SSE__)
TEST(ParallelFor, denormals_are_zero_on_every_thread_and_only_in_tasks) {
    const volatile float smallest = std::numeric_limits<float>::denorm_min();
    const volatile float normal = std::numeric_limits<float>::min();
    const volatile double smallest_double = std::numeric_limits<double>::denorm_min();
    const ThreadLimit limit(4);
    std::atomic<int> not_flushed = 0;
    parallel_for(1000, [&](std::size_t) {
        if (smallest * 0x1p100F != 0) ++not_flushed;  // read as zero
        if (normal * 0.5F != 0) ++not_flushed;        // a result flushed to zero
        if (smallest_double * 0x1p1000 != 0) ++not_flushed;
    });
    EXPECT_EQ(not_flushed, 0);
    EXPECT_NE(smallest * 0x1p100F, 0);  // the caller's own arithmetic is as it was
}
#endif

}  // namespace
}  // namespace sunfleck::engine
