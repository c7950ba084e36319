// zlib streams: what is unpacked is whole, or nothing.
#include "core/zlib_stream.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// "light in the air, light in the air" by Python's zlib.compress().
const std::string kPacked(
    "\x78\x9c\xcb\xc9\x4c\xcf\x28\x51\xc8\xcc\x53\x28\xc9\x48\x55\x48\xcc\x2c\xd2\x51"
    "\xc8\x41\x13\x01\x00\xd1\xdc\x0b\xe5",
    29);
const std::string kText = "light in the air, light in the air";

TEST(ZlibStream, is_unpacked_if_it_is_whole_and_of_the_size_told) {
    EXPECT_EQ(inflated(kPacked, kText.size()), kText);
    EXPECT_FALSE(inflated(kPacked, kText.size() - 1));
    EXPECT_FALSE(inflated(kPacked, kText.size() + 1));
    EXPECT_FALSE(inflated(kPacked.substr(0, 20), kText.size()));
    EXPECT_FALSE(inflated("", 1));
}

TEST(ZlibStream, whose_checksum_is_another_is_nothing) {
    for (std::size_t i = kPacked.size() - 4; i < kPacked.size(); ++i) {
        std::string damaged = kPacked;
        damaged[i] = static_cast<char>(damaged[i] ^ 4);
        EXPECT_FALSE(inflated(damaged, kText.size())) << i;
    }
}

/// Would ask for the memory.
TEST(ZlibStream, that_cannot_hold_so_much_is_not_unpacked) {
    EXPECT_FALSE(inflated(kPacked, std::size_t{1} << 50U));
}

}  // namespace
}  // namespace sunfleck::engine
