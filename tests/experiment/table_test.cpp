// Tables as CSV and HTML: what a field may hold, and numbers.
#include "experiment/table.h"

#include <gtest/gtest.h>

#include <limits>

namespace sunfleck::engine {
namespace {

TEST(NumberText, is_short_and_says_what_is_no_number) {
    EXPECT_EQ(number_text(0.000123456), "0.0001235");
    EXPECT_EQ(number_text(42), "42");
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "-");
    EXPECT_EQ(interval_text({1.234, 1.1, 1.3}), "1.23 [1.1, 1.3]");
}

TEST(Table, csv_quotes_what_it_must) {
    const Table table{"t", "T", {"a", "b,c"}, {{"1 \"x\"", "two\nlines"}, {"", "3"}}};
    EXPECT_EQ(table_csv(table), "a,\"b,c\"\n\"1 \"\"x\"\"\",\"two\nlines\"\n,3\n");
}

TEST(Table, html_shows_text_as_it_is) {
    const Table table{"t", "A < B", {"<c>"}, {{"x & \"y\""}}};
    const std::string html = table_html(table);
    EXPECT_NE(html.find("A &lt; B"), std::string::npos);
    EXPECT_NE(html.find("<th>&lt;c&gt;</th>"), std::string::npos);
    EXPECT_NE(html.find("<td>x &amp; &quot;y&quot;</td>"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
