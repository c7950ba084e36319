// Base64 and escapes, against the examples of RFC 4648.
#include "import/gltf/uri.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(GltfUri, base64_is_that_of_rfc_4648) {
    EXPECT_EQ(from_base64(""), "");
    EXPECT_EQ(from_base64("Zg=="), "f");
    EXPECT_EQ(from_base64("Zm8="), "fo");
    EXPECT_EQ(from_base64("Zm9v"), "foo");
    EXPECT_EQ(from_base64("Zm9vYmFy"), "foobar");
    EXPECT_EQ(from_base64("Zm9vYg"), "foob") << "padding may be missing";
    EXPECT_EQ(from_base64("/+8="), "\xFF\xEF");
    EXPECT_FALSE(from_base64("Zm9v!"));
    EXPECT_FALSE(from_base64("Zm9vY"));
}

TEST(GltfUri, data_has_a_type_and_bytes) {
    const auto data = data_of("data:image/png;base64,Zm9v");
    ASSERT_TRUE(data);
    EXPECT_EQ(data->type, "image/png");
    EXPECT_EQ(data->bytes, "foo");
    EXPECT_EQ(data_of("data:;base64,Zg==")->bytes, "f");
    EXPECT_FALSE(data_of("data:text/plain,foo")) << "not base64";
    EXPECT_FALSE(data_of("data:image/png;base64"));
    EXPECT_FALSE(data_of("foo.bin"));
}

TEST(GltfUri, escapes_are_bytes) {
    EXPECT_EQ(without_escapes("Box%20With%20Spaces.bin"), "Box With Spaces.bin");
    EXPECT_EQ(without_escapes("%c3%A9t%C3%A9.png"), "\xC3\xA9t\xC3\xA9.png");
    EXPECT_EQ(without_escapes("100%.png"), "100%.png");
    EXPECT_EQ(without_escapes("a%2"), "a%2");
}

}  // namespace
}  // namespace sunfleck::engine
