// The picture is the mean over passes; light is scaled, features are not.
#include "film/film_picture.h"

#include "film/error_bars.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

using testing_support::film_of;
using testing_support::noise_pass;
using testing_support::numbers;
using testing_support::small_key;

TEST(FilmPicture, is_the_mean_over_passes) {
    const FilmKey key = small_key();
    const Picture picture = film_picture(film_of(key, numbers(0, 20)), 2);
    std::vector<std::string> names;
    for (const Channel& channel : picture.channels) names.push_back(channel.name);
    EXPECT_EQ(names, (std::vector<std::string>{"R", "G", "B", "caustic.R", "caustic.G", "caustic.B",
                                               "depth.Z"}));
    double red = 0;
    double caustic = 0;
    double depth = 0;
    for (std::uint32_t pass = 0; pass < 20; ++pass) {
        const PassImage image = noise_pass(key, pass);
        red += image.value(Layer::total, 33, 0).to_double();
        caustic += image.value(Layer::caustic, 33, 1).to_double();
        depth += image.value(Layer::depth, 33, 0).to_double();
    }
    EXPECT_FLOAT_EQ(picture.find("R")->values[33], static_cast<float>(2 * red / 20));
    EXPECT_FLOAT_EQ(picture.find("caustic.G")->values[33], static_cast<float>(2 * caustic / 20));
    EXPECT_FLOAT_EQ(picture.find("depth.Z")->values[33], static_cast<float>(depth / 20));
}

TEST(FilmPicture, has_an_error_from_two_rounds_on) {
    const Film film = film_of(small_key(), numbers(0, 32));
    const Picture picture = film_picture(film, 3);
    ASSERT_NE(picture.find("error.Y"), nullptr);
    EXPECT_FLOAT_EQ(picture.find("error.Y")->values[5],
                    static_cast<float>(3 * pixel_errors(film)[5].standard_error));
}

TEST(FilmPicture, without_passes_is_black) {
    const Picture picture = film_picture(Film(small_key()));
    for (const Channel& channel : picture.channels)
        for (const float value : channel.values) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace sunfleck
