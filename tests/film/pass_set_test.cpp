// Sets of passes against a plain table of booleans, in shuffled orders.
#include "film/pass_set.h"

#include "film/film.h"
#include "synthetic.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

/// The set holds what the table holds, in its one form: ranges that ascend and do not touch.
void expect_same(const PassSet& passes, const std::set<std::uint64_t>& table) {
    std::set<std::uint64_t> held;
    std::uint64_t last_end = 0;
    for (const PassRange& range : passes.ranges()) {
        EXPECT_TRUE(range.begin < range.end);
        EXPECT_TRUE(range.begin > last_end || range.begin == 0);
        last_end = range.end;
        for (std::uint64_t i = range.begin; i < range.end; ++i) held.insert(i);
    }
    EXPECT_EQ(held, table);
    EXPECT_EQ(passes.count(), table.size());
}

TEST(PassSet, agrees_with_a_table) {
    for (std::uint32_t which = 0; which < 50; ++which) {
        std::vector<std::uint32_t> order = testing_support::numbers(0, 100);
        testing_support::shuffle(order, which);
        std::set<std::uint64_t> table;
        PassSet passes;
        for (const std::uint32_t pass : order) {
            EXPECT_EQ(passes.count_in({pass, pass + 1U}), 0U);
            passes.insert({pass, pass + 1U});
            table.insert(pass);
            expect_same(passes, table);
        }
        EXPECT_EQ(passes.ranges(), (std::vector<PassRange>{{0, 100}}));
    }
}

}  // namespace
}  // namespace sunfleck::engine
