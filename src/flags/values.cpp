// Values of flags that are more than a number: durations, shares, sizes, rectangles, ranges.
#include "flags/values.h"

#include "scene/adjust.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// A number at the start of `text`; `rest` is what follows it. NaN if there is none.
double leading_number(const std::string& text, std::string& rest) {
    double value = std::nan("");
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc()) value = std::nan("");
    rest.assign(stop, end);
    return value;
}

std::vector<int> integers(const std::string& text, char separator) {
    std::vector<int> values;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    while (true) {
        int value = 0;
        const auto [stop, fault] = std::from_chars(at, end, value);
        if (fault != std::errc()) return {};
        values.push_back(value);
        if (stop == end) return values;
        if (*stop != separator) return {};
        at = stop + 1;
    }
}

}  // namespace

double read_duration(const std::string& text, const std::string& flag) {
    std::string unit;
    const double value = leading_number(text, unit);
    const double seconds = unit == "h"                   ? 3600
                           : unit == "m"                 ? 60
                           : unit.empty() || unit == "s" ? 1
                                                         : 0;
    if (!(value > 0) || seconds == 0 || !std::isfinite(value))
        throw Error({flag}, "\"" + text + "\" is no time", "write 60s, 5m or 2h");
    return value * seconds;
}

double read_share(const std::string& text, const std::string& flag) {
    std::string unit;
    const double value = leading_number(text, unit);
    const double share = unit == "%" ? value / 100 : value;
    if (!(share > 0 && share < 1) || !(unit.empty() || unit == "%"))
        throw Error({flag}, "\"" + text + "\" is no share between 0 and 1", "write 2% or 0.02");
    return share;
}

std::uint64_t read_bytes(const std::string& text, const std::string& flag) {
    std::string unit;
    const double value = leading_number(text, unit);
    double bytes = 0;
    for (const auto& [letter, size] :
         {std::pair{'K', 0x1p10}, {'M', 0x1p20}, {'G', 0x1p30}, {'T', 0x1p40}})
        for (const char* rest : {"", "B", "iB"})
            if (unit == letter + std::string(rest)) bytes = value * size;
    if (!(bytes >= 1 && bytes < 0x1p62))
        throw Error({flag}, "\"" + text + "\" is no size of memory", "write 512M or 4G");
    return static_cast<std::uint64_t>(bytes);
}

double read_positive(const std::string& text, const std::string& flag, int most) {
    std::string rest;
    const double value = leading_number(text, rest);
    if (rest.empty() && value > 0 && value < most) return value;
    throw Error({flag}, "\"" + text + "\" is no number between 0 and " + std::to_string(most),
                "write such a number");
}

double read_number(const std::string& text, const std::string& flag, double low, double high) {
    std::string rest;
    const double value = leading_number(text, rest);
    if (rest.empty() && value >= low && value <= high) return value;
    throw Error({flag}, fmt::format("\"{}\" is no number from {} to {}", text, low, high),
                "write such a number");
}

std::int64_t read_whole(const std::string& text, const std::string& flag, std::int64_t low,
                        std::int64_t high) {
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault == std::errc() && stop == end && value >= low && value <= high) return value;
    throw Error({flag}, fmt::format("\"{}\" is no whole number from {} to {}", text, low, high),
                "write such a number");
}

std::uint64_t read_seed(const std::string& text, const std::string& flag) {
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, seed);
    if (fault != std::errc() || stop != end)
        throw Error({flag}, "\"" + text + "\" is no seed", "write a whole number of 0 to 2^64 - 1");
    return seed;
}

Vec2i read_size(const std::string& text, const std::string& flag) {
    const std::vector<int> v = integers(text, 'x');
    if (v.size() != 2 || !is_film_size({v[0], v[1]}))
        throw Error({flag}, "\"" + text + "\" is no picture size",
                    "write WIDTHxHEIGHT, such as 640x480, of at most 65536 a side and 2^28 pixels");
    return {v[0], v[1]};
}

LightGroupFactor read_factor(const std::string& text, const std::string& flag) {
    const std::size_t equals = std::min(text.find('='), text.size());
    std::vector<float> factors;
    std::string rest = text.substr(equals);
    bool are_right = true;
    while (are_right && !rest.empty()) {
        const bool follows = rest[0] == (factors.empty() ? '=' : ',');
        const double value = leading_number(rest.substr(1), rest);
        are_right = follows && value >= 0 && value <= 1e6;
        factors.push_back(static_cast<float>(value));
    }
    if (!are_right || equals == 0 || (factors.size() != 1 && factors.size() != 3))
        throw Error(
            {flag}, "\"" + text + "\" is no factor of a light group",
            "write NAME=FACTOR, for example sun=0.3, or NAME=R,G,B; numbers from 0 to 1000000");
    factors.resize(3, factors[0]);
    return {text.substr(0, equals), Vec3(factors[0], factors[1], factors[2])};
}

std::array<int, 4> read_crop(const std::string& text, const std::string& flag) {
    const std::vector<int> v = integers(text, ',');
    if (v.size() != 4)
        throw Error({flag}, "\"" + text + "\" is no crop", "write x0,x1,y0,y1 in pixels");
    return {v[0], v[1], v[2], v[3]};
}

std::array<double, 4> read_crop_window(const std::string& text, const std::string& flag) {
    std::array<double, 4> window{};
    std::string rest = ',' + text;
    bool is_right = true;
    for (double& fraction : window) {
        is_right = is_right && !rest.empty() && rest[0] == ',';
        if (!is_right) break;
        fraction = leading_number(rest.substr(1), rest);
        is_right = fraction >= 0 && fraction <= 1;
    }
    if (!is_right || !rest.empty())
        throw Error({flag}, "\"" + text + "\" is no crop window",
                    "write x0,x1,y0,y1 as fractions of the picture, for example 0,0.5,0,1");
    return window;
}

std::array<std::uint32_t, 2> read_pass_range(const std::string& text, const std::string& flag) {
    constexpr int kMost = 1 << 30;
    const std::vector<int> ends = integers(text, ':');
    if (ends.size() != 2 || ends[0] < 0 || ends[0] >= ends[1] || ends[1] > kMost)
        throw Error({flag}, "\"" + text + "\" is no range of passes",
                    "write a:b with a < b, such as 0:64");
    return {static_cast<std::uint32_t>(ends[0]), static_cast<std::uint32_t>(ends[1])};
}

}  // namespace sunfleck::engine
