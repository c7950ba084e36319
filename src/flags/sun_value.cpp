// Dates by the calendar, times with their offset from UTC.
#include "flags/sun_value.h"

#include "flags/values.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace sunfleck::engine {
namespace {

const char* const kSunForms =
    "write AZIMUTH,ELEVATION in degrees, such as 225,40, or DATE,TIME,LATITUDE,LONGITUDE, such as "
    "2026-06-21,15:30+02:00,48.2,16.4";

/// Reads a text of a fixed form: digits where the form has a 0, the same characters elsewhere.
/// @return the numbers between those characters; nothing for another form.
std::optional<std::vector<int>> digits_of(std::string_view text, std::string_view form) {
    if (text.size() != form.size()) return {};
    std::vector<int> numbers;
    bool in_number = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_digit = text[i] >= '0' && text[i] <= '9';
        if (form[i] != '0' ? text[i] != form[i] : !is_digit) return {};
        if (form[i] == '0') {
            if (!in_number) numbers.push_back(0);
            numbers.back() = 10 * numbers.back() + (text[i] - '0');
        }
        in_number = form[i] == '0';
    }
    return numbers;
}

int days_of_month(int year, int month) {
    constexpr std::array kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    return kDays.at(static_cast<std::size_t>(month - 1)) + (month == 2 && is_leap ? 1 : 0);
}

void read_date(const std::string& text, const std::string& flag, CivilTime& time) {
    const auto numbers = digits_of(text, "0000-00-00");
    const bool is_date = numbers && (*numbers)[0] >= 1583 && (*numbers)[1] >= 1 &&
                         (*numbers)[1] <= 12 && (*numbers)[2] >= 1 &&
                         (*numbers)[2] <= days_of_month((*numbers)[0], (*numbers)[1]);
    if (!is_date)
        throw Error({flag}, "\"" + text + "\" is no date of the calendar",
                    "write YEAR-MONTH-DAY, such as 2026-06-21");
    time.year = (*numbers)[0];
    time.month = (*numbers)[1];
    time.day = (*numbers)[2];
}

/// Returns hours of a clock, or of an offset; nothing for what is none.
std::optional<double> hours_of(std::string_view text) {
    auto numbers = digits_of(text, "00:00");
    if (!numbers) numbers = digits_of(text, "00:00:00");
    if (!numbers) return {};
    numbers->resize(3);
    const auto& [hour, minute, second] = std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    if (hour > 24 || minute > 59 || second > 59) return {};
    return hour + minute / 60.0 + second / 3600.0;
}

void read_time(const std::string& text, const std::string& flag, CivilTime& time) {
    const std::size_t sign = text.find_first_of("+-Z");
    const auto hours = hours_of(text.substr(0, sign));
    std::optional<double> offset;
    if (sign != std::string::npos)
        offset = text.substr(sign) == "Z" ? 0 : hours_of(text.substr(sign + 1));
    if (!hours || !offset)
        throw Error({flag}, "\"" + text + "\" is no time with its offset from UTC",
                    "write HH:MM+HH:MM, such as 15:30+02:00, or 13:30Z");
    time.hours = *hours;
    time.utc_offset = text[sign] == '-' ? -*offset : *offset;
}

std::vector<std::string> words_between_commas(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

}  // namespace

SunPosition read_sun(const std::string& text, const std::string& flag) {
    const std::vector<std::string> words = words_between_commas(text);
    SunPosition sun;
    if (words.size() == 2) {
        sun.azimuth = read_number(words[0], flag, -360, 360);
        sun.elevation = read_number(words[1], flag, -90, 90);
    } else if (words.size() == 4) {
        CivilTime time;
        read_date(words[0], flag, time);
        read_time(words[1], flag, time);
        sun = solar_position(time, {.latitude = read_number(words[2], flag, -90, 90),
                                    .longitude = read_number(words[3], flag, -180, 180)});
    } else {
        throw Error({flag}, "\"" + text + "\" is no place of the sun", kSunForms);
    }
    if (!(sun.elevation >= 0))
        throw Error({flag},
                    fmt::format("the sun is {:.1f} degrees below the horizon", -sun.elevation),
                    "choose a time of the day, or an elevation from 0 to 90");
    return sun;
}

}  // namespace sunfleck::engine
