// One pixel of each cell.
#include "camera/pixel_window.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

TEST(PixelCells, have_one_pixel_each) {
    for (const int side : {1, 2, 3, 5}) {
        const PixelCells cells{{3, 5, 20, 16}, side};  // 17 x 11
        std::set<std::size_t> chosen;
        for (std::size_t i = 0; i < cells.window.pixels(); ++i)
            if (cells.has(i)) chosen.insert(i);
        EXPECT_EQ(chosen.size(), static_cast<std::size_t>(cells.across() * cells.down()));
        for (int y = 0; y < cells.down(); ++y)
            for (int x = 0; x < cells.across(); ++x) {
                const std::size_t pixel = cells.pixel_of(x, y);
                EXPECT_EQ(chosen.count(pixel), 1U);
                EXPECT_EQ(pixel % 17 / static_cast<std::size_t>(side), x);
                EXPECT_EQ(pixel / 17 / static_cast<std::size_t>(side), y);
                EXPECT_EQ(cells.cell_of(pixel), static_cast<std::size_t>(y * cells.across() + x));
            }
    }
}

// A lamp may be seen edge-on, one row high.
TEST(PixelCells, leave_no_row_or_column_out) {
    const PixelCells cells{{0, 0, 27, 27}, 3};
    std::set<std::size_t> rows;
    std::set<std::size_t> columns;
    for (std::size_t i = 0; i < cells.window.pixels(); ++i) {
        if (!cells.has(i)) continue;
        rows.insert(i / 27);
        columns.insert(i % 27);
    }
    EXPECT_EQ(rows.size(), 27U);
    EXPECT_EQ(columns.size(), 27U);
}

}  // namespace
}  // namespace sunfleck::engine
