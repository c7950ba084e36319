// What a picture says of the render that made it.
#include "film/film_metadata.h"

#include "film/film_picture.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_of;
using testing_support::numbers;
using testing_support::small_key;

TEST(FilmMetadata, are_those_of_a_single_render_after_a_merge) {
    FilmKey key = small_key();
    key.seed = 41;
    key.scene_hash = 0xABC;
    key.settings = "integrator=sppm\nalpha=0.5\n";
    Film whole = film_of(key, numbers(0, 6));
    whole.sum("uniform_paths", 600);
    whole.sum("guided_paths", 30);
    Film first = film_of(key, numbers(0, 2));
    first.sum("uniform_paths", 200);
    Film second = film_of(key, numbers(2, 6));
    second.sum("uniform_paths", 400);
    second.sum("guided_paths", 30);
    merge(first, second);
    const auto texts = film_metadata(first);
    EXPECT_EQ(texts, film_metadata(whole));
    EXPECT_EQ(texts.at("software"), "Sunfleck " SUNFLECK_VERSION);
    EXPECT_EQ(texts.at("passes"), "6");
    EXPECT_EQ(texts.at("seed"), "41");
    EXPECT_EQ(texts.at("photon_paths"), "630");
    EXPECT_EQ(texts.at("scene_hash"), "0000000000000abc");
    EXPECT_EQ(texts.at("settings"), key.settings);
    EXPECT_FALSE(film_metadata(film_of(key, {})).contains("photon_paths"));
    EXPECT_EQ(film_picture(whole).metadata.at("seed"), "41");
}

TEST(FilmMetadata, know_the_shape_of_pixels) {
    FilmKey key = small_key();
    EXPECT_EQ(pixel_aspect_of(key), 1);
    key.settings = "alpha=0.5\npixel_aspect=1.25\n";
    EXPECT_EQ(pixel_aspect_of(key), 1.25F);
    EXPECT_EQ(film_picture(film_of(key, numbers(0, 1))).pixel_aspect, 1.25F);
}

}  // namespace
}  // namespace sunfleck::engine
