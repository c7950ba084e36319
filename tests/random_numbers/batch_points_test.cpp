// Batch points: within a batch every pixel's pairs are a net; batches are fresh; all are uniform.
#include "random_numbers/batch_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

TEST(BatchPoints, a_round_is_a_net_in_every_pair) {
    for (const std::uint32_t pixel : {0U, 77U}) {
        for (unsigned split = 0; split <= 4; ++split) {
            for (int pair = 0; pair < 5; ++pair) {
                std::set<int> cells;
                for (std::uint32_t pass = 32; pass < 48; ++pass) {
                    BatchPoints points({5, pass}, pixel);
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
        BatchPoints points(pass, 77, path);
        points.next_2d();
        points.next_2d();
        const Vec2d u = points.next_2d();
        const auto x = static_cast<std::uint32_t>(u.x * (1U << columns));
        const auto y = static_cast<std::uint32_t>(u.y * (1U << rows));
        cells.insert(x << rows | y);
    }
    return cells;
}

TEST(BatchPoints, several_paths_of_a_pixel_are_a_net_in_a_pass_and_a_finer_one_in_the_round) {
    for (std::uint32_t log2_samples = 1; log2_samples <= 6; ++log2_samples) {
        std::vector<std::pair<PassId, PathOfPixel>> batch;
        for (std::uint32_t pass = 32; pass < 48; ++pass) {
            std::vector<std::pair<PassId, PathOfPixel>> here;
            for (std::uint32_t number = 0; number < 1U << log2_samples; ++number)
                here.push_back({{5, pass}, {number, log2_samples}});
            for (std::uint32_t split = 0; split <= log2_samples; ++split)
                EXPECT_EQ(cells_of(here, split, log2_samples - split).size(), here.size());
            batch.insert(batch.end(), here.begin(), here.end());
        }
        for (std::uint32_t split = 0; split <= 4 + log2_samples; ++split)
            EXPECT_EQ(cells_of(batch, split, 4 + log2_samples - split).size(), batch.size());
    }
}

TEST(BatchPoints, batches_pixels_and_replicates_differ) {
    EXPECT_NE(BatchPoints({5, 0}, 1).next(), BatchPoints(PassId{5, 0}.replicate(1), 1).next());
    EXPECT_NE(BatchPoints({5, 0}, 1).next(), BatchPoints({5, 16}, 1).next());
    EXPECT_NE(BatchPoints({5, 0}, 1).next(), BatchPoints({5, 0}, 2).next());
    EXPECT_NE(BatchPoints({5, 0}, 1).next(), BatchPoints({6, 0}, 1).next());
}

// 65,536 pixels of one pass: means of x, y and xy within 4 standard errors (sees 0.005).
TEST(BatchPoints, one_pass_is_uniform_over_pixels) {
    constexpr std::uint32_t kPixels = 65536;
    Vec2d sum(0);
    double product = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        BatchPoints points({9, 3}, pixel);
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
}  // namespace sunfleck::engine
