// The function at each number of 16 bits.
#include "live/tones.h"

#include "image/tone.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kPositive = 0x8000;  // numbers of 16 bits

/// Returns a value to six digits: a screen has fewer.
double few_digits(double value) {
    constexpr double kDigits = 1e6;
    return std::round(value * kDigits) / kDigits;
}

std::vector<double> table_of(const ToneCurve& curve) {
    std::vector<double> values;
    values.reserve(kPositive);
    for (std::uint32_t half = 0; half < kPositive; ++half) {
        const double light = std::bit_cast<float>(half << 16U);
        const bool is_white = light >= curve.white || std::isnan(light);
        const double value = is_white ? 1 : light > 0 ? curve.value(light) : 0;
        values.push_back(few_digits(value));
    }
    return values;
}

}  // namespace

std::string tone_json(std::string_view name) {
    const auto* row = row_named(kTones, name);
    const ToneCurve& curve = tone_curve(row == nullptr ? Tone::none : row->value);
    return nlohmann::json{{"in", curve.in},
                          {"out", curve.out},
                          {"decoding", curve.decoding},
                          {"values", table_of(curve)}}
        .dump();
}

}  // namespace sunfleck::engine
