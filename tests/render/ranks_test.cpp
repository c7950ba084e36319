// What ranks say to each other, and how passes are dealt to them.
#include "ranks/ranks.h"

#include "film/synthetic.h"
#include "ranks/film_transfer.h"
#include "ranks/reduction_interval.h"
#include "support/thread_ranks.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

TEST(Ranks, hand_up_to_rank_0_in_their_order) {
    for (int size = 1; size <= 20; ++size) {
        std::string whole;
        std::string all;
        on_ranks(size, [&](const Ranks& ranks) {
            std::string mine = std::to_string(ranks.rank) + " ";
            hand_up(
                ranks, [&](int from) { mine += receive_text(ranks, from); },
                [&](int to) { send_text(ranks, to, mine); });
            if (ranks.is_first()) all = mine;
        });
        for (int rank = 0; rank < size; ++rank) whole += std::to_string(rank) + " ";
        EXPECT_EQ(all, whole);
    }
}

TEST(Ranks, rank_0_reaches_all) {
    for (int size = 1; size <= 20; ++size) {
        std::atomic<int> reached{0};
        on_ranks(size, [&](const Ranks& ranks) {
            std::array<int, 3> word{ranks.rank, ranks.rank, ranks.rank};
            if (ranks.is_first()) word = {7, 8, 9};
            broadcast(ranks, std::as_writable_bytes(std::span(word)));
            if (word == std::array<int, 3>{7, 8, 9}) ++reached;
        });
        EXPECT_EQ(reached, size);
    }
}

TEST(Ranks, all_hear_the_text_of_the_lowest_that_has_one) {
    for (const int lowest : {0, 1, 4, 6, 9}) {
        std::atomic<int> heard{0};
        on_ranks(7, [&](const Ranks& ranks) {
            const std::string mine =
                ranks.rank >= lowest ? "fault of " + std::to_string(ranks.rank) : "";
            const std::string wanted = lowest < 7 ? "fault of " + std::to_string(lowest) : "";
            if (first_text(ranks, mine) == wanted) ++heard;
        });
        EXPECT_EQ(heard, 7) << lowest;
    }
}

TEST(FilmTransfer, a_film_arrives_as_it_is) {
    std::vector<std::uint32_t> passes = numbers(3, 40);  // a batch, and three that are open
    passes.push_back(70);
    const Film film = film_of(small_key(), passes);
    ASSERT_EQ(film.sums().open_groups.size(), 7U);
    on_ranks(2, [&](const Ranks& ranks) {
        if (!ranks.is_first()) return send_film(ranks, 0, film);
        const Film arrived = receive_film(ranks, 1);
        EXPECT_TRUE(arrived.sums() == film.sums());
    });
}

/// docs/guide/clusters.md: 88.5 bytes a pixel, 48.75 for each group of an open batch, 16.75 for
/// early batches, some hundreds for the head; 64.25, 48 and 16.25 without discs; 48 for a light
/// group.
TEST(FilmTransfer, sends_the_sums_and_little_more) {
    FilmKey key = small_key(64, 64);
    key.aovs = {};
    key.light_groups = {};
    const auto sent = [&key](std::uint32_t begin, std::uint32_t end) {
        const Film film = film_of(key, numbers(begin, end));
        return on_ranks(2, [&](const Ranks& ranks) {
            if (ranks.is_first())
                receive_film(ranks, 1);
            else
                send_film(ranks, 0, film);
        });
    };
    constexpr double kPixels = 64.0 * 64;
    EXPECT_NEAR(static_cast<double>(sent(16, 32)), 88.5 * kPixels + 300, 200);
    EXPECT_NEAR(static_cast<double>(sent(21, 36)), (88.5 + 4 * 48.75) * kPixels + 300, 200);
    EXPECT_NEAR(static_cast<double>(sent(0, 16)), (88.5 + 16.75) * kPixels + 300, 200);
    key.alpha = 0;
    EXPECT_NEAR(static_cast<double>(sent(0, 16)), (64.25 + 16.25) * kPixels + 300, 200);
    EXPECT_NEAR(static_cast<double>(sent(16, 32)), 64.25 * kPixels + 300, 200);
    EXPECT_NEAR(static_cast<double>(sent(16, 36)), (64.25 + 48) * kPixels + 300, 200);
    EXPECT_NEAR(static_cast<double>(sent(21, 36)), (64.25 + 4 * 48) * kPixels + 300, 200);
    key.light_groups = {"sun", "lamp"};
    EXPECT_NEAR(static_cast<double>(sent(16, 32)), (64.25 + 2 * 48) * kPixels + 300, 200);
}

void expect_even_blocks(const PassRange& interval, int size) {
    std::uint64_t next = interval.begin;
    const std::uint64_t least = interval.size() / static_cast<std::uint64_t>(size);
    for (int rank = 0; rank < size; ++rank) {
        const PassRange block = block_of(interval, rank, size);
        EXPECT_EQ(block.begin, next);
        EXPECT_GE(block.size(), least);
        EXPECT_LE(block.size(), least + 1);
        next = block.end;
    }
    EXPECT_EQ(next, interval.end);
}

TEST(Turns, blocks_are_neighbours_of_even_length) {
    for (const int size : {1, 2, 3, 16, 17, 1000})
        for (const std::uint64_t passes : {1U, 16U, 999U, 1000U, 1001U})
            expect_even_blocks({37, 37 + passes}, size);
}

TEST(Turns, are_cut_where_batches_end) {
    EXPECT_EQ(cut_at_batches({16, 32}), (std::vector<PassRange>{{16, 32}}));
    EXPECT_EQ(cut_at_batches({21, 25}), (std::vector<PassRange>{{21, 25}}));
    EXPECT_EQ(cut_at_batches({0, 9}),
              (std::vector<PassRange>{{0, 1}, {1, 2}, {2, 4}, {4, 6}, {6, 8}, {8, 9}}));
    EXPECT_EQ(cut_at_batches({14, 50}),
              (std::vector<PassRange>{{14, 16}, {16, 32}, {32, 48}, {48, 50}}));
    EXPECT_EQ(common({3, 9}, {5, 20}), (PassRange{5, 9}));
    EXPECT_EQ(common({3, 9}, {9, 20}).size(), 0U);
    EXPECT_EQ(common({12, 15}, {3, 9}).size(), 0U);
}

TEST(Turns, are_as_long_as_time_allows) {
    EXPECT_EQ(passes_of_interval({1, 0.1, 10, false, {}}), 1U) << "alone: a pass";
    EXPECT_EQ(passes_of_interval({3, 0, 10, false, {}}), 3U) << "nothing known: a pass each";
    EXPECT_EQ(passes_of_interval({3, 0.5, 10, false, {}}), 60U);
    EXPECT_EQ(passes_of_interval({3, 0.5, 0.2, false, {}}), 3U);
    EXPECT_EQ(passes_of_interval({3, 0.5, -5, false, {}}), 3U);
    EXPECT_EQ(passes_of_interval({3, 0.5, 10, true, {}}), 15U) << "less than a round is lost";
    EXPECT_EQ(passes_of_interval({100, 0.5, 10, true, {}}), 100U);
    EXPECT_EQ(passes_of_interval({3, 0.5, 10, false, 7}), 7U);
    EXPECT_EQ(passes_of_interval({3, 1e-300, 10, false, {}}), 3U << 20U);
}

}  // namespace
}  // namespace sunfleck::engine
