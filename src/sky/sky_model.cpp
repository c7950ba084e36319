// The model's formulas; their letters are those of the papers.
#include "sky/sky_model.h"

#include "math/trigonometry.h"
#include "sky/data_hosek_wilkie.inc"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kTurbidities = 10;
constexpr std::size_t kPoints = 6;  // of a curve in elevation
constexpr std::size_t kPieces = 45;

/// Two turbidities of the tables around a given one.
struct Turbidities {
    std::size_t low;  // index
    double rest;      // share of the next

    explicit Turbidities(double turbidity)
        : low(static_cast<std::size_t>(std::clamp(turbidity, 1.0, 10.0)) - 1),
          rest(std::clamp(turbidity, 1.0, 10.0) - 1 - static_cast<double>(low)) {}

    /// Returns between(low), mixed with between(low + 1).
    template <class At>
    double mixed(At at) const {
        const double value = at(low);
        return rest > 0 ? value + rest * (at(low + 1) - value) : value;
    }
};

/// Returns exp(x). In double its last bits differ between machines; in float they do not.
double exponential(double x) {
    return std::exp(static_cast<float>(x));
}

/// Returns the cube root of a number in [0, 1], with the same bits on all machines.
double cube_root(double x) {
    if (!(x > 0)) return 0;
    const double near = std::cbrt(static_cast<float>(x));
    return near - (near * near * near - x) / (3 * near * near);  // Newton's method
}

/// Returns the cube root of the elevation over 90 degrees, in which the tables are curves.
double along_curves(double elevation) {
    return cube_root(std::clamp(elevation / (kPiDouble / 2), 0.0, 1.0));
}

/// Returns a Bezier curve of fifth degree. @param point  its control points.
template <class Point>
double bezier(double t, Point point) {
    constexpr std::array<double, kPoints> kBinomials = {1, 5, 10, 10, 5, 1};
    std::array<double, kPoints> t_power{1};
    std::array<double, kPoints> rest_power{1};
    for (std::size_t i = 1; i < kPoints; ++i) {
        t_power.at(i) = t_power.at(i - 1) * t;
        rest_power.at(i) = rest_power.at(i - 1) * (1 - t);
    }
    double sum = 0;
    for (std::size_t i = 0; i < kPoints; ++i)
        sum += kBinomials.at(i) * t_power.at(i) * rest_power.at(kPoints - 1 - i) * point(i);
    return sum;
}

/// Returns one of the `count` coefficients per control point of a table for the dome.
template <class Table>
double of_dome(const Table& table, const SkyState& state, std::size_t count, std::size_t number) {
    const Turbidities turbidities(state.turbidity);
    const double t = along_curves(state.elevation);
    const auto with_albedo = [&](std::size_t albedo) {
        return turbidities.mixed([&](std::size_t turbidity) {
            const std::size_t first = (albedo * kTurbidities + turbidity) * kPoints;
            return bezier(
                t, [&](std::size_t i) { return double{table[(first + i) * count + number]}; });
        });
    };
    return with_albedo(0) * (1 - state.ground_albedo) + with_albedo(1) * state.ground_albedo;
}

}  // namespace

SkyModel::SkyModel(const SkyState& state) : turbidity_(state.turbidity) {
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) {
        for (std::size_t i = 0; i < 9; ++i) shape_[w][i] = of_dome(kSkyDome[w], state, 9, i);
        radiance_[w] = of_dome(kSkyRadiance[w], state, 1, 0);
    }
}

SkyCurve SkyModel::sky(double cos_zenith, double cos_sun) const {
    const double half_chord = std::sqrt(std::clamp((1 - cos_sun) / 2, 0.0, 1.0));
    const double angle = 2 * std::asin(static_cast<float>(half_chord));
    const double rayleigh = cos_sun * cos_sun;
    const double root = std::sqrt(std::max(cos_zenith, 0.0));
    SkyCurve curve{};
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) {
        const auto& c = shape_[w];
        const double around = 1 + c[8] * c[8] - 2 * c[8] * cos_sun;
        const double mie = (1 + rayleigh) / (around * std::sqrt(around));
        const double horizon = 1 + c[0] * exponential(c[1] / (cos_zenith + 0.01));
        curve[w] =
            radiance_[w] * horizon *
            (c[2] + c[3] * exponential(c[4] * angle) + c[5] * rayleigh + c[6] * mie + c[7] * root);
    }
    return curve;
}

SkyCurve SkyModel::sun(double elevation) const {
    const double along = along_curves(elevation) * kPieces;
    const std::size_t piece = std::min(static_cast<std::size_t>(along), kPieces - 1);
    const double begin = static_cast<double>(piece) / kPieces;
    const double x = elevation - begin * begin * begin * (kPiDouble / 2);
    const Turbidities turbidities(turbidity_);
    SkyCurve curve{};
    for (std::size_t w = 0; w < kSkyWavelengths; ++w)
        curve[w] = std::max(0.0, turbidities.mixed([&](std::size_t turbidity) {
            const float* c = &kSunRadiance[w][(turbidity * kPieces + piece) * 4];
            return ((c[0] * x + c[1]) * x + c[2]) * x + c[3];
        }));
    return curve;
}

std::array<SkyCurve, 6> SkyModel::limb_darkening() {
    std::array<SkyCurve, 6> coefficients{};
    for (std::size_t power = 0; power < coefficients.size(); ++power)
        for (std::size_t w = 0; w < kSkyWavelengths; ++w)
            coefficients[power][w] = kLimbDarkening[w][power];
    return coefficients;
}

}  // namespace sunfleck::engine
