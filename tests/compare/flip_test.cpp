// FLIP against the figures of its authors' program.
//
// The figures: FLIP.h of github.com/NVlabs/flip at 1eb247cab (version 1.7), compiled by g++ 12 and
// run on the pictures made here; mean, and pixels (0,0), (12,10), (31,23) of the map. Both programs
// compute in floats, in other orders: they agree within 1e-4 (a thousandth of what is visible).
#include "compare/flip.h"

#include "compare/pictures.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::picture;
using testing_support::plain;

constexpr double kTolerance = 1e-4;

struct Figures {
    double mean;
    double first;
    double inside;
    double last;
};

void expect_figures(const std::vector<float>& map, const Figures& figures) {
    ASSERT_EQ(map.size(), 32U * 24U);
    double sum = 0;
    for (const float value : map) sum += static_cast<double>(value);
    EXPECT_NEAR(sum / static_cast<double>(map.size()), figures.mean, kTolerance);
    EXPECT_NEAR(map.front(), figures.first, kTolerance);
    EXPECT_NEAR(map[10 * 32 + 12], figures.inside, kTolerance);
    EXPECT_NEAR(map.back(), figures.last, kTolerance);
}

RgbImage edge(int at) {
    return picture([=](int x, int, int c) {
        return (x < at ? Vec3(0.8F, 0.3F, 0.1F) : Vec3(0.1F, 0.2F, 0.6F))[c];
    });
}

float steps(int k) {
    return static_cast<float>(k % 32) / 31.0F;
}

/// A texture of all frequencies. @param change  0 or 1: what of it is another.
RgbImage texture(int change) {
    return picture([=](int x, int y, int c) {
        return steps(7 * x + 13 * y + 29 * c + change * ((5 * x * y + 3 * c) % 4));
    });
}

/// The same over nine stops of light.
RgbImage bright_texture(int change) {
    const RgbImage base = texture(change);
    return picture([&](int x, int y, int c) {
        const float stops = static_cast<float>((3 * x + y) % 9) - 2;
        return (0.1F + base.pixels[static_cast<std::size_t>(32 * y + x)][c]) * std::exp2(stops);
    });
}

TEST(Flip, of_plain_colours_is_that_of_its_authors) {
    const double uniform = 0.1346988;
    expect_figures(ldr_flip(plain({0.2F, 0.4F, 0.6F}), plain({0.25F, 0.4F, 0.6F})),
                   {uniform, uniform, uniform, uniform});
    const double contrast = 0.967388;
    expect_figures(ldr_flip(plain(Vec3(0)), plain(Vec3(1))),
                   {contrast, contrast, contrast, contrast});
}

/// The largest difference that there is, by its definition.
TEST(Flip, of_green_and_blue_is_one) {
    expect_figures(ldr_flip(plain({0, 1, 0}), plain({0, 0, 1})), {1, 1, 1, 1});
}

TEST(Flip, of_equal_pictures_is_zero) {
    expect_figures(ldr_flip(texture(0), texture(0)), {0, 0, 0, 0});
    expect_figures(hdr_flip(bright_texture(0), bright_texture(0)), {0, 0, 0, 0});
}

TEST(Flip, of_an_edge_that_moved_is_that_of_its_authors) {
    expect_figures(ldr_flip(edge(10), edge(12)), {0.1560534, 0.006459, 0.497199, 0});
}

TEST(Flip, of_a_texture_is_that_of_its_authors) {
    expect_figures(ldr_flip(texture(0), texture(1)), {0.2974290, 0.969028, 0.140181, 0.537654});
}

TEST(Flip, cuts_light_that_a_screen_does_not_show) {
    expect_figures(ldr_flip(bright_texture(0), bright_texture(1)),
                   {0.1554490, 0.429047, 0.088369, 0.028875});
}

TEST(HdrFlip, is_that_of_its_authors) {
    expect_figures(hdr_flip(bright_texture(0), bright_texture(1)),
                   {0.2100837, 0.430697, 0.177044, 0.415431});
    expect_figures(hdr_flip(edge(10), edge(12)), {0.1177977, 0.003797, 0.381887, 0});
    const double uniform = 0.1223089;
    expect_figures(hdr_flip(plain({0.2F, 0.4F, 0.6F}), plain({0.25F, 0.4F, 0.6F})),
                   {uniform, uniform, uniform, uniform});
}

TEST(HdrFlip, exposures_are_those_of_its_authors) {
    const std::vector<float> exposures = hdr_exposures(bright_texture(0));
    ASSERT_EQ(exposures.size(), 5U);
    EXPECT_NEAR(exposures.front(), -4.84619, 1e-4);
    EXPECT_NEAR(exposures.back(), -0.09354, 1e-4);
}

/// Where the reference program has no answer: more than half of the picture is black.
TEST(HdrFlip, of_a_dark_picture_goes_by_what_is_lit) {
    const auto lit = [](int x, int, int) { return x < 4 ? 1.0F : 0.0F; };
    EXPECT_EQ(hdr_exposures(picture(lit)), hdr_exposures(plain(Vec3(1))));
    EXPECT_TRUE(hdr_flip(plain(Vec3(0)), plain(Vec3(1))).empty());
}

TEST(HdrFlip, takes_light_of_any_size) {
    for (const float value : hdr_flip(plain(Vec3(1)), plain(Vec3(3e38F)))) {
        EXPECT_GT(value, 0.1F);
        EXPECT_LE(value, 1.0F);
    }
}

}  // namespace
}  // namespace sunfleck::engine
