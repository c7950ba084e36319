// Values of flags as users write them.
#include "flags/values.h"

#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// The text is refused in words that name the flag and the text itself.
template <class Read>
void expect_refused(Read read, const std::string& text) {
    try {
        read(text, "--flag");
        ADD_FAILURE() << '"' << text << "\" is taken";
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("--flag: ")) << error.what();
        EXPECT_NE(std::string(error.what()).find('"' + text + '"'), std::string::npos)
            << error.what();
    }
}

TEST(Values, durations_have_units) {
    EXPECT_EQ(read_duration("90", "--flag"), 90);
    EXPECT_EQ(read_duration("1.5m", "--flag"), 90);
    EXPECT_EQ(read_duration("2h", "--flag"), 7200);
    for (const char* text : {"", "m", "5x", "0", "-1s", "nan", "inf", "1e400"})
        expect_refused(read_duration, text);
}

TEST(Values, shares_are_between_0_and_1) {
    EXPECT_EQ(read_share("2%", "--flag"), 0.02);
    EXPECT_EQ(read_share("0.5", "--flag"), 0.5);
    for (const char* text : {"", "0", "1", "100%", "-2%", "2 %", "nan"})
        expect_refused(read_share, text);
}

TEST(Values, numbers_include_the_ends_of_their_range) {
    EXPECT_EQ(read_number("0.25", "--flag", 0.25, 1), 0.25);
    EXPECT_EQ(read_number("1", "--flag", 0.25, 1), 1);
    EXPECT_EQ(read_whole("-3", "--flag", -3, 7), -3);
    EXPECT_EQ(read_whole("7", "--flag", -3, 7), 7);
    for (const char* text : {"", "0.2", "1.1", "nan", "inf", "1x", " 1"})
        expect_refused(number_from(0.25, 1), text);
    for (const char* text : {"", "-4", "8", "1.5", "99999999999999999999", "0x1", "1e0"})
        expect_refused(whole_from(-3, 7), text);
}

TEST(Values, sizes_of_memory_are_powers_of_1024) {
    EXPECT_EQ(read_bytes("1K", "--flag"), 1024U);
    EXPECT_EQ(read_bytes("1.5GiB", "--flag"), 1536U << 20U);
    for (const char* text : {"", "5", "5X", "-1G", "0M"}) expect_refused(read_bytes, text);
}

TEST(Values, pictures_have_sizes_crops_and_pass_ranges) {
    EXPECT_EQ(read_size("640x480", "--flag"), Vec2i(640, 480));
    EXPECT_EQ(read_crop("1,2,3,4", "--flag"), (std::array<int, 4>{1, 2, 3, 4}));
    EXPECT_EQ(read_crop_window("0,0.5,0,1", "--flag"), (std::array<double, 4>{0, 0.5, 0, 1}));
    EXPECT_EQ(read_pass_range("3:64", "--flag"), (std::array<std::uint32_t, 2>{3, 64}));
    for (const char* text : {"", "640", "640x", "0x1", "1x1x1"}) expect_refused(read_size, text);
    for (const char* text : {"", "4:4", "5:4", "1:2x", "1"}) expect_refused(read_pass_range, text);
}

TEST(Values, factors_of_light_groups) {
    const LightGroupFactor one = read_factor("sun=0.5", "--flag");
    EXPECT_EQ(one.name, "sun");
    for (const char* text : {"sun", "sun=", "=1", "sun=1,2", "sun=-1", "sun=x"})
        expect_refused(read_factor, text);
}

}  // namespace
}  // namespace sunfleck::engine
