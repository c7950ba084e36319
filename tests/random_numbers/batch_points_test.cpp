// Round points: within a round every pixel's pairs are a net; rounds are fresh; all are uniform.
#include "random_numbers/batch_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace sunfleck {
namespace {

TEST(RoundPoints, a_round_is_a_net_in_every_pair) {
    for (const std::uint32_t pixel : {0U, 77U}) {
        for (unsigned split = 0; split <= 4; ++split) {
            for (int pair = 0; pair < 5; ++pair) {
                std::set<int> cells;
                for (std::uint32_t pass = 32; pass < 48; ++pass) {
                    RoundPoints points({5, pass}, pixel);
                    Vec2d u;
                    for (int skip = 0; skip <= pair; ++skip) u = points.next_2d();
                    const int x = static_cast<int>(u.x * (1 << split));
                    const int y = static_cast<int>(u.y * (16 >> split));
                    cells.insert(x * 16 + y);
                }
                EXPECT_EQ(cells.size(), 16U) << split << " " << pair;
            }
        }
    }
}

/// Cells of a grid of 2^columns x 2^rows in which some paths' third pair lies.
std::set<std::uint32_t> cells_of(const std::vector<std::pair<PassId, PathOfPixel>>& paths,
                                 std::uint32_t columns, std::uint32_t rows) {
    std::set<std::uint32_t> cells;
    for (const auto& [pass, path] : paths) {
        RoundPoints points(pass, 77, path);
        points.next_2d();
        points.next_2d();
        const Vec2d u = points.next_2d();
        const auto x = static_cast<std::uint32_t>(u.x * (1U << columns));
        const auto y = static_cast<std::uint32_t>(u.y * (1U << rows));
        cells.insert(x << rows | y);
    }
    return cells;
}

TEST(RoundPoints, several_paths_of_a_pixel_are_a_net_in_a_pass_and_a_finer_one_in_the_round) {
    for (std::uint32_t doublings = 1; doublings <= 6; ++doublings) {
        std::vector<std::pair<PassId, PathOfPixel>> round;
        for (std::uint32_t pass = 32; pass < 48; ++pass) {
            std::vector<std::pair<PassId, PathOfPixel>> here;
            for (std::uint32_t number = 0; number < 1U << doublings; ++number)
                here.push_back({{5, pass}, {number, doublings}});
            for (std::uint32_t split = 0; split <= doublings; ++split)
                EXPECT_EQ(cells_of(here, split, doublings - split).size(), here.size());
            round.insert(round.end(), here.begin(), here.end());
        }
        for (std::uint32_t split = 0; split <= 4 + doublings; ++split)
            EXPECT_EQ(cells_of(round, split, 4 + doublings - split).size(), round.size());
    }
}

TEST(RoundPoints, draws_of_a_pass_are_a_net_together) {
    constexpr std::uint32_t kDraws = 4;
    std::vector<std::pair<PassId, PathOfPixel>> round;
    for (std::uint32_t pass = 16; pass < 32; ++pass)
        for (std::uint32_t draw = 0; draw < kDraws; ++draw)
            for (const std::uint32_t number : {0U, 1U})
                round.push_back({{5, pass}, {number, 1, {draw, kDraws}}});
    for (std::uint32_t split = 0; split <= 7; ++split)
        EXPECT_EQ(cells_of(round, split, 7 - split).size(), round.size());
}

// Three draws are no power of two: of 64 points 48, no two in one cell.
TEST(RoundPoints, any_number_of_draws_has_points_of_its_own) {
    std::vector<std::pair<PassId, PathOfPixel>> round;
    for (std::uint32_t pass = 0; pass < 16; ++pass)
        for (std::uint32_t draw = 0; draw < 3; ++draw)
            round.push_back({{5, pass}, {0, 0, {draw, 3}}});
    EXPECT_EQ(cells_of(round, 3, 3).size(), round.size());
}

TEST(RoundPoints, rounds_pixels_and_draws_differ) {
    EXPECT_NE(RoundPoints({5, 0}, 1).next(), RoundPoints(PassId{5, 0}.draw(1), 1).next());
    EXPECT_NE(RoundPoints({5, 0}, 1, {0, 0, {0, 2}}).next(),
              RoundPoints({5, 0}, 1, {0, 0, {1, 2}}).next());
    EXPECT_NE(RoundPoints({5, 0}, 1).next(), RoundPoints({5, 16}, 1).next());
    EXPECT_NE(RoundPoints({5, 0}, 1).next(), RoundPoints({5, 0}, 2).next());
    EXPECT_NE(RoundPoints({5, 0}, 1).next(), RoundPoints({6, 0}, 1).next());
}

// 65,536 pixels of one pass: means of x, y and xy within 4 standard errors (sees 0.005).
TEST(RoundPoints, one_pass_is_uniform_over_pixels) {
    constexpr std::uint32_t kPixels = 65536;
    Vec2d sum(0);
    double product = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        RoundPoints points({9, 3}, pixel);
        points.next();
        const Vec2d u = points.next_2d();
        sum += u;
        product += u.x * u.y;
    }
    const double error = std::sqrt(1.0 / 12 / kPixels);
    EXPECT_NEAR(sum.x / kPixels, 0.5, 4 * error);
    EXPECT_NEAR(sum.y / kPixels, 0.5, 4 * error);
    EXPECT_NEAR(product / kPixels, 0.25, 4 * error);
}

}  // namespace
}  // namespace sunfleck
