// Layers of IDs keep their bits, whatever is asked for.
#include "image/id_layers.h"

#include "image/exr.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <bit>

namespace sunfleck::engine {
namespace {

Picture picture_with_ids() {
    Picture picture{2, 1, {}, {{"cryptomatte/3ae39a5/name", "CryptoObject"}}};
    for (const char* name : {"R", "CryptoObject00.R", "CryptoObject00.G", "CryptoObjects.R"})
        picture.add(name).values = {std::bit_cast<float>(0x13851A76U), 0.123456789F};
    return picture;
}

TEST(IdLayers, are_those_that_the_attributes_name) {
    const Picture picture = picture_with_ids();
    EXPECT_TRUE(holds_ids(picture, "CryptoObject00"));
    EXPECT_TRUE(holds_ids(picture, "CryptoObject12"));
    EXPECT_TRUE(holds_ids(picture, "CryptoObject"));
    EXPECT_FALSE(holds_ids(picture, "CryptoObjects"));
    EXPECT_FALSE(holds_ids(picture, "CryptoObject0"));
    EXPECT_FALSE(holds_ids(picture, "picture"));
}

TEST(IdLayers, have_32_bits_beside_layers_of_halves) {
    const Picture picture = picture_with_ids();
    for (const ExrOptions& options :
         {ExrOptions{.half = true}, ExrOptions{.half = true, .parts = true},
          ExrOptions{.half_layers = {"CryptoObject00"}}}) {
        const Picture read = parse_exr(exr_bytes(picture, options), "a.exr");
        for (const char* name : {"CryptoObject00.R", "CryptoObject00.G"})
            EXPECT_EQ(read.find(name)->values, picture.find(name)->values) << name;
        EXPECT_EQ(read.find("R")->values == picture.find("R")->values, !options.half);
    }
}

TEST(IdLayers, refuse_compressions_that_would_change_them) {
    Picture picture = picture_with_ids();
    for (const ExrCompression lossy : {ExrCompression::dwaa, ExrCompression::dwab})
        EXPECT_THROW(exr_bytes(picture, {.compression = lossy}), Error);
    EXPECT_NO_THROW(exr_bytes(picture, {.compression = ExrCompression::piz}));
    picture.metadata.clear();
    EXPECT_NO_THROW(exr_bytes(picture, {.compression = ExrCompression::dwaa}));
}

}  // namespace
}  // namespace sunfleck::engine
