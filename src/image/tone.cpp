// The three published curves, with their numbers.
#include "image/tone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

constexpr Rows kNoChange = {Triple{1, 0, 0}, Triple{0, 1, 0}, Triple{0, 0, 1}};

/// Returns the matrix with each row divided by its sum: published digits are few.
Rows grey_kept(Rows rows) {
    for (Triple& row : rows) {
        const double sum = row[0] + row[1] + row[2];
        for (double& value : row) value /= sum;
    }
    return rows;
}

double light_itself(double light) {
    return light;
}

/// Hable's curve x (a x + b) / (c x^2 + d x + e) of twice the light, before its division by the
/// value of white. Its six numbers A to F are multiplied out, so that black is black exactly.
double hable_curve(double light) {
    constexpr double kA = 0.15;
    constexpr double kB = 0.50;
    constexpr double kC = 0.10;
    constexpr double kD = 0.20;
    constexpr double kE = 0.02;
    constexpr double kF = 0.30;
    const double x = 2 * light;
    return x * (kA * (kF - kE) * x + kB * (kC * kF - kE)) / (kF * (x * (kA * x + kB) + kD * kF));
}

constexpr double kHableWhite = 11.2 / 2;

double hable_value(double light) {
    static const double white = hable_curve(kHableWhite);
    return hable_curve(light) / white;
}

/// Hill's fit of the ACES reference rendering and output transforms. It is below 0 for light
/// below .0033, which becomes black.
double hill_value(double light) {
    const double above = light * (light + 0.0245786) - 0.000090537;
    const double below = light * (0.983729 * light + 0.4329510) + 0.238081;
    return std::max(above / below, 0.0);
}

/// Light at which hill_value() is 1: the larger root of a quadratic equation.
double hill_white() {
    constexpr double kSquare = 1 - 0.983729;
    constexpr double kLinear = 0.4329510 - 0.0245786;
    constexpr double kConstant = 0.238081 + 0.000090537;
    return (kLinear + std::sqrt(kLinear * kLinear + 4 * kSquare * kConstant)) / (2 * kSquare);
}

constexpr double kStopsBelowGrey = 10;
constexpr double kStopsAboveGrey = 6.5;
constexpr double kGrey = 0.18;

/// One side of the sigmoid of AgX: leaves the pivot with the common slope, and is 1 where
/// `distance` is `span`.
/// @param distance  from the pivot, in [0, span].
double sigmoid_side(double distance, double span, double power) {
    constexpr double kSlope = 2;
    constexpr double kHeight = 0.5;  // of each side: the pivot is at half
    const double rise = kSlope * span;
    const double scale = rise / std::pow(std::pow(rise / kHeight, power) - 1, 1 / power);
    const double x = kSlope * distance / scale;
    return scale * x / std::pow(1 + std::pow(x, power), 1 / power);
}

/// AgX: a sigmoid of the logarithm of light, encoded for a screen's power of 2.2.
double agx_value(double light) {
    constexpr double kToePower = 3;
    constexpr double kShoulderPower = 3.25;
    constexpr double kPivot = kStopsBelowGrey / (kStopsBelowGrey + kStopsAboveGrey);
    const double stops = std::log2(light / kGrey);
    const double x = std::max((stops + kStopsBelowGrey) / (kStopsBelowGrey + kStopsAboveGrey), 0.0);
    const double encoded = x < kPivot ? 0.5 - sigmoid_side(kPivot - x, kPivot, kToePower)
                                      : 0.5 + sigmoid_side(x - kPivot, 1 - kPivot, kShoulderPower);
    return std::max(encoded, 0.0);
}

/// sRGB to the channels of the ACES fit, with its saturation.
const Rows kAcesIn = {Triple{0.59719, 0.35458, 0.04823}, Triple{0.07600, 0.90834, 0.01566},
                      Triple{0.02840, 0.13383, 0.83777}};
const Rows kAcesOut = {Triple{1.60475, -0.53108, -0.07367}, Triple{-0.10208, 1.10813, -0.00605},
                       Triple{-0.00327, -0.07276, 1.07602}};
/// sRGB to the narrower primaries of AgX.
const Rows kAgxIn = {Triple{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                     Triple{0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                     Triple{0.0423756549057051, 0.0784336, 0.879142973793104}};

}  // namespace

const ToneCurve& tone_curve(Tone tone) {
    static const std::array<ToneCurve, kTones.size()> all = {{
        {.in = kNoChange, .out = kNoChange, .white = 1, .value = light_itself},
        {.in = kNoChange, .out = kNoChange, .white = kHableWhite, .value = hable_value},
        {.in = grey_kept(kAcesIn),
         .out = grey_kept(kAcesOut),
         .white = hill_white(),
         .value = hill_value},
        {.in = grey_kept(kAgxIn),
         .out = inverse(grey_kept(kAgxIn)),
         .white = kGrey * std::exp2(kStopsAboveGrey),
         .value = agx_value,
         .decoding = 2.2},
    }};
    return all.at(static_cast<std::size_t>(tone));
}

Vec3 toned(Tone tone, const Vec3& light) {
    const ToneCurve& curve = tone_curve(tone);
    // Of infinities the matrices would make no numbers.
    constexpr double kMost = std::numeric_limits<float>::max();
    Triple channels = {std::min<double>(light.x, kMost), std::min<double>(light.y, kMost),
                       std::min<double>(light.z, kMost)};
    if (tone != Tone::none) channels = curve.in * channels;
    for (double& channel : channels)
        channel = !(channel > 0) ? 0 : channel >= curve.white ? 1 : curve.value(channel);
    if (tone != Tone::none) channels = curve.out * channels;
    Vec3 shown;
    for (int c = 0; c < 3; ++c) {
        const double value = std::clamp(channels.at(static_cast<std::size_t>(c)), 0.0, 1.0);
        shown[c] =
            static_cast<float>(curve.decoding == 1 ? value : std::pow(value, curve.decoding));
    }
    return shown;
}

}  // namespace sunfleck::engine
