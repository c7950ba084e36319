// Light groups as users ask for them.
#include "flags/light_groups.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

std::vector<AskedLightGroup> groups_of(const std::vector<std::string>& texts) {
    std::vector<AskedLightGroup> groups;
    for (const std::string& text : texts) add_light_group(text, groups);
    return groups;
}

TEST(AskedLightGroups, have_names_and_runs_of_lights) {
    const auto groups = groups_of({"sun=1,3-5", "lamps=2"});
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].name, "sun");
    EXPECT_EQ(groups[0].text, "1,3-5");
    using Runs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(groups[0].runs, (Runs{{1, 1}, {3, 5}}));
    EXPECT_TRUE(groups_of({"each"})[0].name.empty());
}

TEST(AskedLightGroups, are_named_apart_or_each_alone) {
    for (const std::vector<std::string>& texts : {std::vector<std::string>{"a=1", "a=2"},
                                                  {"each", "a=1"},
                                                  {"a=1", "each"},
                                                  {"each", "each"}})
        EXPECT_THROW(groups_of(texts), Error) << texts[0] << " " << texts[1];
}

}  // namespace
}  // namespace sunfleck::engine
