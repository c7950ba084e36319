// Charts: points lie where the axes say, and what an axis cannot show is left out.
#include "experiment/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace sunfleck::engine {
namespace {

struct Mark {
    double x;
    double y;
};

std::vector<Mark> marks(const std::string& svg) {
    const std::regex circle("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
    std::vector<Mark> found;
    for (auto i = std::sregex_iterator(svg.begin(), svg.end(), circle); i != std::sregex_iterator();
         ++i)
        found.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
    return found;
}

TEST(Chart, has_logarithmic_axes) {
    const Chart chart{"c",
                      "C",
                      "x",
                      "y",
                      {{"line", {{1, 1, 1, 1}, {10, 0.1, 0.1, 0.1}, {100, 0.01, 0.01, 0.01}}}},
                      true};
    const std::vector<Mark> at = marks(chart_svg(chart));
    ASSERT_EQ(at.size(), 3U);
    EXPECT_NEAR(at[1].x - at[0].x, at[2].x - at[1].x, 0.15);
    EXPECT_NEAR(at[1].y - at[0].y, at[2].y - at[1].y, 0.15);
    EXPECT_GT(at[1].y, at[0].y);  // downwards
}

TEST(Chart, leaves_out_what_it_cannot_show) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Chart chart{
        "c",
        "a < b",
        "x",
        "y",
        {{"line", {{1, 1, -1, 2}, {2, -1, -1, -1}, {3, nan, 1, 1}, {4, 2, 1, 3}}}, {"nothing", {}}},
        true};
    const std::string svg = chart_svg(chart);
    EXPECT_EQ(marks(svg).size(), 2U);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_NE(svg.find(">nothing<"), std::string::npos);
}

TEST(Chart, stands_without_any_point_and_with_one) {
    EXPECT_EQ(chart_svg({"c", "", "", "", {}, true}).find("nan"), std::string::npos);
    for (const bool log : {true, false}) {
        const std::string svg = chart_svg({"c", "", "", "", {{"l", {{5, 0.5, 0.5, 0.5}}}}, log});
        const std::vector<Mark> at = marks(svg);
        ASSERT_EQ(at.size(), 1U);
        EXPECT_TRUE(at[0].x > 76 && at[0].x < 492 && at[0].y > 34 && at[0].y < 346);
    }
}

/// On a plain axis equal steps are equal.
TEST(Chart, may_have_a_plain_axis) {
    const Chart chart{"c",  "", "", "", {{"l", {{1, 0, 0, 0}, {2, 0.5, 0.5, 0.5}, {4, 1, 1, 1}}}},
                      false};
    const std::vector<Mark> at = marks(chart_svg(chart));
    ASSERT_EQ(at.size(), 3U);
    EXPECT_NEAR(at[0].y - at[1].y, at[1].y - at[2].y, 0.15);
}

}  // namespace
}  // namespace sunfleck::engine
