// The page as text: all is in it, and nothing of it is elsewhere.
#include "report/page.h"

#include <gtest/gtest.h>
#include <half.h>

#include <regex>

namespace sunfleck::engine {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

/// RFC 4648, section 10.
TEST(Base64, is_that_of_the_standard) {
    EXPECT_EQ(base64(bytes_of("")), "");
    EXPECT_EQ(base64(bytes_of("f")), "Zg==");
    EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
    EXPECT_EQ(base64(bytes_of("foo")), "Zm9v");
    EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
    EXPECT_EQ(base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0xFE}), "+//+");
}

float value_of(const HalfPixels& pixels, std::size_t channel) {
    half value;
    value.setBits(static_cast<unsigned short>(pixels.bytes[2 * channel] |
                                              pixels.bytes[2 * channel + 1] << 8));
    return value;
}

TEST(HalfPixels, keep_three_digits_and_what_is_no_number) {
    const HalfPixels pixels = half_pixels({1, 1, {Vec3(0.1F, NAN, -INFINITY)}});
    EXPECT_EQ(pixels.scale, 1);
    EXPECT_NEAR(value_of(pixels, 0), 0.1, 0.1 / 2048);
    EXPECT_TRUE(std::isnan(value_of(pixels, 1)));
    EXPECT_EQ(value_of(pixels, 2), -INFINITY);
}

TEST(HalfPixels, hold_light_of_any_size) {
    const HalfPixels pixels = half_pixels({1, 1, {Vec3(3e9F, 1e6F, INFINITY)}});
    EXPECT_NEAR(value_of(pixels, 0) / pixels.scale, 3e9, 3e9 / 2048);
    EXPECT_NEAR(value_of(pixels, 1) / pixels.scale, 1e6, 1e6 / 1024);
    EXPECT_EQ(value_of(pixels, 2), INFINITY);
}

Compared compared(const std::string& label, const Vec3& colour) {
    Compared picture;
    picture.input = {label, label + ".exr"};
    picture.shown = label + ".exr";
    picture.image = {2, 1, {colour, colour}};
    return picture;
}

Comparison comparison() {
    Comparison c{compared("truth", Vec3(1)),
                 {compared("</script><b>", Vec3(0.5F)), compared("b", Vec3(2))}};
    for (Compared& picture : c.pictures)
        picture.measured = measure(c.reference.image, picture.image);
    return c;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++found;
    return found;
}

TEST(Page, holds_all_pictures) {
    const Comparison c = comparison();
    const std::string page = report_page(c);
    const std::vector<Compared> all = {c.reference, c.pictures[0], c.pictures[1]};
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(count(page, "id=\"pixels-" + std::to_string(i) + "\" data-scale=\"1\">" +
                                  base64(half_pixels(all[i].image).bytes) + "</script>"),
                  1U);
    EXPECT_EQ(count(page, "<script type=\"text/plain\""), 5U);  // two maps of FLIP
}

TEST(Page, refers_to_nothing_outside) {
    Comparison c = comparison();
    c.pictures[0].seeds = 1;  // brings the chart library, whose comments name its home
    std::string page = report_page(c);
    EXPECT_NE(page.find("Chart.js"), std::string::npos);
    page = std::regex_replace(
        page, std::regex(R"(https://(www\.chartjs\.org|github\.com/kurkle/color)[^\s]*)"), "");
    for (const char* reference :
         {"http:", "https:", "//cdn", "@import", "url(", "src=", "fetch(", "XMLHttpRequest"})
        EXPECT_EQ(count(page, reference), 0U) << reference;
    EXPECT_EQ(count(page, "<link "), 1U);  // the icon, empty
    EXPECT_EQ(count(page, "href="), 1U);
    EXPECT_EQ(count(page, "href=\"data:,\""), 1U);
    EXPECT_EQ(count(page, "default-src 'none'"), 1U);
}

TEST(Page, has_no_chart_library_without_series) {
    EXPECT_EQ(report_page(comparison()).find("Chart.js Contributors"), std::string::npos);
}

/// A label is shown as it is; it cannot end a script.
TEST(Page, is_not_broken_by_names) {
    const std::string page = report_page(comparison());
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_NE(page.find("\\u003c/script>\\u003cb>"), std::string::npos);
    EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
}

TEST(Page, has_no_mark_left) {
    const std::string page = report_page(comparison());
    EXPECT_EQ(page.find("<!-- "), std::string::npos);
    EXPECT_TRUE(page.starts_with("<!doctype html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
}

}  // namespace
}  // namespace sunfleck::engine
