// Hashes and IDs against published values.
#include "mattes/matte_id.h"

#include "mattes/murmur3.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Source: I. Boyd's table of test vectors (stackoverflow.com/questions/14747343).
TEST(Murmur3, agrees_with_its_test_vectors) {
    using namespace std::string_view_literals;
    EXPECT_EQ(murmur3_32(""), 0U);
    EXPECT_EQ(murmur3_32("", 1), 0x514E28B7U);
    EXPECT_EQ(murmur3_32("", 0xFFFFFFFF), 0x81F16F39U);
    EXPECT_EQ(murmur3_32("\xFF\xFF\xFF\xFF"sv), 0x76293B50U);
    EXPECT_EQ(murmur3_32("\x21\x43\x65\x87"sv), 0xF55B516BU);
    EXPECT_EQ(murmur3_32("\x21\x43\x65\x87"sv, 0x5082EDEE), 0x2362F9DEU);
    EXPECT_EQ(murmur3_32("\x21\x43\x65"sv), 0x7E4A8634U);
    EXPECT_EQ(murmur3_32("\x21\x43"sv), 0xA0F7B07AU);
    EXPECT_EQ(murmur3_32("\x21"sv), 0x72661CF4U);
    EXPECT_EQ(murmur3_32("\0\0\0\0"sv), 0x2362F9DEU);
    EXPECT_EQ(murmur3_32("\0\0\0"sv), 0x85F0B427U);
    EXPECT_EQ(murmur3_32("\0\0"sv), 0x30F4C306U);
    EXPECT_EQ(murmur3_32("\0"sv), 0x514E28B7U);
}

/// Source: Cryptomatte Specification 1.2.0: its examples of hashes and of manifests.
TEST(MatteId, agrees_with_the_examples_of_the_specification) {
    EXPECT_EQ(murmur3_32("torus"), 4053562365U);
    EXPECT_FLOAT_EQ(std::bit_cast<float>(matte_id("torus")), -1.54943624832e+30F);
    const std::string plain = "\xD1\x80\xD0\xB0\xD0\xB2\xD0\xBD\xD0\xB8\xD0\xBD\xD0\xB0";
    EXPECT_EQ(murmur3_32(plain), 2518896926U);
    EXPECT_FLOAT_EQ(std::bit_cast<float>(matte_id(plain)), -1.31926312124e-25F);
    EXPECT_EQ(hex_of(matte_id("bunny")), "13851a76");
    EXPECT_EQ(hex_of(matte_id("default")), "42c9679f");
}

/// Source: the sample files of the same project, made by other renderers.
TEST(MatteId, agrees_with_the_manifests_of_sample_files) {
    EXPECT_EQ(hex_of(matte_id("sphere_?_2")), "86de553a");
    EXPECT_EQ(hex_of(matte_id("has_*_asterisk")), "5def0d04");
    EXPECT_EQ(hex_of(matte_id("name, with, comma")), "62fa4db8");
    EXPECT_EQ(hex_of(matte_id("name_containing/slash")), "b0a04231");
}

TEST(MatteId, is_a_normal_float_whatever_the_hash) {
    int toggled = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::string name = "name" + std::to_string(i);
        EXPECT_TRUE(std::isnormal(std::bit_cast<float>(matte_id(name)))) << name;
        if (matte_id(name) != murmur3_32(name)) ++toggled;
    }
    // Two of 256 exponents are none of a normal float: 156 of these names, give or take 5
    // deviations.
    EXPECT_NEAR(toggled, 20000 * 2 / 256.0, 5 * 12.5);
}

TEST(MatteId, of_exponents_0_and_255_differs_in_one_bit) {
    EXPECT_EQ(murmur3_32("name279"), 0x001007E9U);
    EXPECT_EQ(matte_id("name279"), 0x009007E9U);
    EXPECT_EQ(murmur3_32("name764"), 0x7F95A576U);
    EXPECT_EQ(matte_id("name764"), 0x7F15A576U);
}

TEST(MatteId, names_become_utf_8) {
    EXPECT_EQ(as_utf8("m\xC3\xA4"
                      "dchen \xF0\x9F\x8C\xB5"),
              "m\xC3\xA4"
              "dchen \xF0\x9F\x8C\xB5");
    EXPECT_EQ(as_utf8("m\xE4"
                      "dchen"),
              "m\xEF\xBF\xBD"
              "dchen");
    EXPECT_EQ(as_utf8("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // overlong
    EXPECT_EQ(as_utf8("\xE0\x80\x80").size(), 9U);
    EXPECT_EQ(as_utf8("\xF0\x80\x80\x80").size(), 12U);
    EXPECT_EQ(as_utf8("\xED\xA0\x80").size(), 9U);                 // half a surrogate
    EXPECT_EQ(as_utf8("a\xE2\x82"), "a\xEF\xBF\xBD\xEF\xBF\xBD");  // cut off
    EXPECT_EQ(as_utf8("\xF4\x90\x80\x80").size(), 12U);            // beyond U+10FFFF
}

}  // namespace
}  // namespace sunfleck::engine
