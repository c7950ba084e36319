// The list of figures and their cells.
#include "experiment/figure_cells.h"
#include "experiment/methods.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace sunfleck::engine {
namespace {

TEST(Figures, are_found_by_their_names) {
    EXPECT_EQ(figure_named("fig6").name, "fig6");
    EXPECT_THROW(figure_named("fig2"), Error);
}

TEST(Figures, have_cells_of_all_seeds_and_a_reference_for_each_scene) {
    RunSettings settings;
    settings.seeds = 3;
    for (const Figure& figure : figures()) {
        EXPECT_FALSE(figure.claim.empty());
        const std::vector<Cell> cells = cells_of(figure, settings);
        for (const std::string& scene : figure.scenes) {
            const auto references = std::count_if(cells.begin(), cells.end(), [&](const Cell& c) {
                return c.scene == scene && c.method.name.starts_with("reference-");
            });
            EXPECT_EQ(references, 1) << figure.name << scene;
        }
        for (const Cell& cell : cells) {
            if (figure.name == "table1" || cell.seed > 3) continue;
            const Cell last{cell.scene, cell.method, 3};
            EXPECT_TRUE(std::any_of(cells.begin(), cells.end(), [&](const Cell& c) {
                return c.key() == last.key();
            })) << cell.key();
        }
    }
}

/// Figures share renders: one name is one set of flags, and each cell is there once.
TEST(Figures, cells_of_one_name_are_one_render) {
    const std::vector<Cell> cells = cells_of(figures(), {});
    std::map<std::string, std::vector<std::string>> flags;
    std::map<std::string, int> count;
    for (const Cell& cell : cells) {
        EXPECT_EQ(++count[cell.key()], 1) << cell.key();
        const auto known = flags.emplace(cell.scene + "/" + cell.method.name, cell.method.flags);
        EXPECT_EQ(known.first->second, cell.method.flags) << cell.key();
    }
}

TEST(Reference, is_not_made_by_what_is_under_test_where_that_can_be) {
    EXPECT_EQ(reference_cell("cornell", {}).method.name, "reference-path");
    EXPECT_EQ(reference_cell("room", {}).method.name, "reference-uniform");
    EXPECT_EQ(reference_cell("cognac-4", {}).method.name, "reference-adaptive");
    EXPECT_EQ(reference_cell("cognac-4", {}).seed, 1000U);
}

}  // namespace
}  // namespace sunfleck::engine
