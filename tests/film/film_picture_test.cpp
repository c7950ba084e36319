// The picture is the mean over passes, with its error and bias.
#include "film/film_picture.h"

#include "film/bias.h"
#include "film/luminance.h"
#include "math/spectrum.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_of;
using testing_support::noise_pass;
using testing_support::numbers;
using testing_support::small_key;

double luminance_at(const Picture& picture, std::size_t i) {
    return luminance(
        {picture.find("R")->values[i], picture.find("G")->values[i], picture.find("B")->values[i]});
}

TEST(FilmPicture, is_the_mean_over_passes) {
    const FilmKey key = small_key();
    const Picture picture = film_picture(film_of(key, numbers(0, 20)));
    std::vector<std::string> names;
    for (const Channel& channel : picture.channels) names.push_back(channel.name);
    EXPECT_EQ(names, (std::vector<std::string>{"R", "G", "B", "caustic.R", "caustic.G", "caustic.B",
                                               "depth.Z", "sun.R", "sun.G", "sun.B", "lamp.R",
                                               "lamp.G", "lamp.B", "error.Y"}));
    double red = 0;
    double caustic = 0;
    double depth = 0;
    double lamp = 0;
    for (std::uint32_t pass = 0; pass < 20; ++pass) {
        const PassImage image = noise_pass(key, pass);
        // The first four are small, and the last four count less.
        const double share = (pass < 4 ? 0.25 : pass < kBatchPasses ? 1 : 0.25) / 14;
        red += share * image.value(Aov::total, 33, 0).to_double();
        caustic += share * image.value(Aov::caustic, 33, 1).to_double();
        depth += share * image.value(Aov::depth, 33, 0).to_double();
        lamp += share * image.light_value(1, 33, 2).to_double();
    }
    EXPECT_FLOAT_EQ(picture.find("R")->values[33], static_cast<float>(red));
    EXPECT_FLOAT_EQ(picture.find("caustic.G")->values[33], static_cast<float>(caustic));
    EXPECT_FLOAT_EQ(picture.find("depth.Z")->values[33], static_cast<float>(depth));
    EXPECT_FLOAT_EQ(picture.find("lamp.B")->values[33], static_cast<float>(lamp));
    EXPECT_EQ(picture.metadata.at(kLightGroupNames), "sun lamp");
}

/// As if a lamp of three lines lit a white wall, and nothing else made noise.
Film film_of_wavelengths(std::uint64_t seed, std::uint32_t passes, std::uint64_t small) {
    const Spectrum lamp = *named_spectrum("stdillum-F11");
    FilmKey key{1, 1, {}, seed, 0, ""};
    key.small_passes = small;
    Film film(key);
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
        const Wavelengths drawn = Wavelengths::of_pass({seed, pass});
        PassImage image(1, key.aovs);
        image.add_light(0, drawn.to_rgb(lamp.at(drawn)), Aov::direct);
        film.add_pass(pass, image);
    }
    return film;
}

/// Root mean square of its brightness's error. 200 seeds: known to 5%.
double wavelength_error(std::uint32_t passes, std::uint64_t small = 0) {
    const Vec3 exact = named_spectrum("stdillum-F11")->to_rgb();
    const double truth = luminance({exact[0], exact[1], exact[2]});
    double squares = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Film film = film_of_wavelengths(seed, passes, small);
        const double off = luminance_at(film_picture(film), 0) / truth - 1;
        squares += off * off / 200;
        EXPECT_NEAR(image_mean(film) / luminance_at(film_picture(film), 0), 1, 1e-6);
    }
    return std::sqrt(squares);
}

/// Passes of an open batch that count like the others made up to 3.7%.
TEST(FilmPicture, of_passes_beyond_a_batch_is_hardly_off_by_their_wavelengths) {
    EXPECT_LT(wavelength_error(16), 0.004);
    for (std::uint32_t passes = 17; passes < 32; ++passes)
        EXPECT_LT(wavelength_error(passes), 0.008) << passes;
}

/// The small ones, and the rest of the first batch, are evenly spread each. Two would not be.
TEST(FilmPicture, of_small_passes_is_hardly_off_by_their_wavelengths) {
    EXPECT_LT(wavelength_error(4, kSmallPasses), 0.04);
    for (const std::uint32_t passes : {16U, 32U, 64U})
        EXPECT_LT(wavelength_error(passes, kSmallPasses), 0.012) << passes;
    EXPECT_GT(wavelength_error(16, 2), 0.025);
}

TEST(FilmPicture, of_a_part_of_one_batch_is_the_plain_mean) {
    const FilmKey key = small_key();
    const Film film = film_of(key, numbers(16, 27));
    EXPECT_EQ(film.passes_in_picture(), 11);
    EXPECT_FLOAT_EQ(film_picture(film).find("R")->values[33],
                    static_cast<float>(film.sums().aovs[0][99].to_double() / 11));
}

/// Parts of batches: 12 passes of one, 3 of another, none complete; the first counts in full.
TEST(FilmPicture, of_two_parts_of_batches_weighs_them_by_their_passes) {
    const FilmKey key{1, 1, {}, 1, 0, ""};
    Film film(key);
    for (const std::uint32_t pass :
         {0U, 1U, 2U, 16U, 17U, 18U, 19U, 20U, 21U, 22U, 23U, 24U, 25U, 26U, 27U}) {
        PassImage image(1, key.aovs);
        image.add_light(0, Vec3(pass < 16 ? 1 : 2), Aov::direct);
        film.add_pass(pass, image);
    }
    EXPECT_NEAR(luminance_at(film_picture(film), 0), (3 * 0.25 + 2 * 12) / (3 * 0.25 + 12), 1e-6);
}

TEST(FilmPicture, has_an_error_from_two_batches_on) {
    const Film film = film_of(small_key(), numbers(0, 2));
    const Picture picture = film_picture(film);
    ASSERT_NE(picture.find("error.Y"), nullptr);
    EXPECT_FLOAT_EQ(picture.find("error.Y")->values[5],
                    static_cast<float>(widening(film) * pixel_errors(film)[5].standard_error));
    EXPECT_GT(widening(film), 6);
    EXPECT_EQ(film_picture(film_of(small_key(), numbers(0, 1))).find("error.Y"), nullptr);
}

TEST(FilmPicture, has_a_bias_from_four_batches_on) {
    const Film film = film_of(small_key(), numbers(0, 64));
    const Picture picture = film_picture(film);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(picture.find(std::string("bias.") + "RGB"[c])->values[7],
                        static_cast<float>(pixel_biases(film)[7].at(c)));
    EXPECT_FALSE(picture.metadata.contains(kExtrapolated));
    EXPECT_EQ(film_picture(film_of(small_key(), numbers(0, 63))).find("bias.R"), nullptr);
}

TEST(FilmPicture, extrapolated_is_less_its_bias_and_has_the_error_of_that) {
    const Film film = film_of(small_key(), numbers(0, 70));
    const Picture plain = film_picture(film);
    const Picture picture = film_picture(film, {true});
    for (const char* channel : {"R", "G", "B"}) {
        const std::string bias = std::string("bias.") + channel;
        EXPECT_EQ(picture.find(bias)->values, plain.find(bias)->values);
        EXPECT_FLOAT_EQ(picture.find(channel)->values[7],
                        plain.find(channel)->values[7] - plain.find(bias)->values[7]);
    }
    EXPECT_NE(luminance_at(picture, 7), luminance_at(plain, 7));
    EXPECT_FLOAT_EQ(picture.find("error.Y")->values[7],
                    static_cast<float>(line_widening(film) * extrapolated_pixel_errors(film)[7]));
    EXPECT_EQ(picture.find("caustic.R")->values, plain.find("caustic.R")->values);
    EXPECT_EQ(picture.metadata.count(kExtrapolated), 1U);
}

TEST(FilmPicture, is_as_it_was_where_there_is_nothing_to_extrapolate) {
    FilmKey key = small_key();
    EXPECT_EQ(film_picture(film_of(key, numbers(0, 63)), {true}),
              film_picture(film_of(key, numbers(0, 63))));
    key.alpha = 0;
    EXPECT_EQ(film_picture(film_of(key, numbers(0, 64)), {true}),
              film_picture(film_of(key, numbers(0, 64))));
}

TEST(FilmPicture, without_passes_is_black) {
    const Picture picture = film_picture(Film(small_key()));
    for (const Channel& channel : picture.channels)
        for (const float value : channel.values) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace sunfleck::engine
