// The picture is the mean over passes, with its error and bias.
#include "film/film_picture.h"

#include "film/bias.h"
#include "film/luminance.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

using testing_support::film_of;
using testing_support::noise_pass;
using testing_support::numbers;
using testing_support::small_key;
using testing_support::weight_of_round;

TEST(FilmPicture, is_the_mean_over_passes) {
    const FilmKey key = small_key();
    const Picture picture = film_picture(film_of(key, numbers(0, 20)));
    std::vector<std::string> names;
    for (const Channel& channel : picture.channels) names.push_back(channel.name);
    EXPECT_EQ(names, (std::vector<std::string>{"R", "G", "B", "caustic.R", "caustic.G", "caustic.B",
                                               "depth.Z", "sun.R", "sun.G", "sun.B", "lamp.R",
                                               "lamp.G", "lamp.B"}));
    double red = 0;
    double caustic = 0;
    double depth = 0;
    double lamp = 0;
    for (std::uint32_t pass = 0; pass < 20; ++pass) {
        const PassImage image = noise_pass(key, pass);
        const double share = weight_of_round(pass / kRoundPasses) / 32.0;  // of 16 and 4 times 4
        red += share * image.value(Layer::total, 33, 0).to_double();
        caustic += share * image.value(Layer::caustic, 33, 1).to_double();
        depth += share * image.value(Layer::depth, 33, 0).to_double();
        lamp += share * image.light_value(1, 33, 2).to_double();
    }
    EXPECT_FLOAT_EQ(picture.find("R")->values[33], static_cast<float>(red));
    EXPECT_FLOAT_EQ(picture.find("caustic.G")->values[33], static_cast<float>(caustic));
    EXPECT_FLOAT_EQ(picture.find("depth.Z")->values[33], static_cast<float>(depth));
    EXPECT_FLOAT_EQ(picture.find("lamp.B")->values[33], static_cast<float>(lamp));
    EXPECT_EQ(picture.metadata.at(kLightLayerNames), "sun lamp");
}

TEST(FilmPicture, has_an_error_from_two_rounds_on) {
    const Film film = film_of(small_key(), numbers(0, 32));
    const Picture picture = film_picture(film);
    ASSERT_NE(picture.find("error.Y"), nullptr);
    EXPECT_FLOAT_EQ(picture.find("error.Y")->values[5],
                    static_cast<float>(widening(film) * pixel_errors(film)[5].standard_error));
    EXPECT_GT(widening(film), 6);
}

double luminance_at(const Picture& picture, std::size_t i) {
    return luminance(
        {picture.find("R")->values[i], picture.find("G")->values[i], picture.find("B")->values[i]});
}

TEST(FilmPicture, has_a_bias_from_four_rounds_on) {
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
}  // namespace sunfleck
