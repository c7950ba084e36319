// Sums of exponentials by wavelength, and their inverse by Newton's method.
#include "medium/free_path.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kNewtonSteps = 64;
constexpr float kNewtonPrecision = 1e-6F;

/// Returns exp(-rate * distance), one for a rate of zero at any distance.
float left_of(float rate, float distance) {
    return rate > 0 ? std::exp(-rate * distance) : 1;
}
/// Returns one minus that, exact where it is small.
float lost_of(float rate, float distance) {
    return rate > 0 ? -std::expm1(-rate * distance) : 0;
}

SampledSpectrum shares_of(const SampledSpectrum& carried) {
    const float all = carried.sum();
    return all > 0 ? carried / all : SampledSpectrum(1.0F / kWavelengths);
}

}  // namespace

SampledSpectrum transmittance(const SampledMedium& medium, const Ray& way) {
    const float passed = amount(medium, way);
    const SampledSpectrum extinction = medium.absorption + medium.scattering;
    // Fog and dust are grey: one exponential in place of eight.
    if (extinction.min() == extinction.max())
        return SampledSpectrum(left_of(extinction[0], passed));
    SampledSpectrum left;
    for (std::size_t i = 0; i < kWavelengths; ++i) left[i] = left_of(extinction[i], passed);
    return left;
}

FreePath::FreePath(const SampledMedium& medium, const SampledSpectrum& carried)
    : medium_(medium), shares_(shares_of(carried)), least_(kInfinity) {
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        if (!(shares_[i] > 0)) continue;
        least_ = std::min(least_, medium.scattering[i]);
        most_ = std::max(most_, medium.scattering[i]);
    }
}

FreePath::Sums FreePath::sums_at(float distance) const {
    Sums sums;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        if (!(shares_[i] > 0)) continue;
        const float more = medium_.scattering[i] - least_;
        const float fallen = lost_of(more, distance);
        sums.fallen -= shares_[i] * fallen;
        sums.density += shares_[i] * (1 - fallen) * medium_.scattering[i];
    }
    return sums;
}

float FreePath::chance_between(float from, float to) const {
    float chance = 0;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        chance += shares_[i] * left_of(medium_.scattering[i], from) *
                  lost_of(medium_.scattering[i], to - from);
    return chance;
}

float FreePath::density(float distance) const {
    return left_of(least_, distance) * sums_at(distance).density;
}

/// -ln(1 - F) is concave, so that each step from below stays below.
float FreePath::distance_at(float chance) const {
    const float depth = -std::log1p(-chance);
    if (least_ == most_) return depth / most_;
    float distance = 0;
    for (int step = 0; step < kNewtonSteps; ++step) {
        const Sums sums = sums_at(distance);
        const float missing = depth - (least_ * distance - std::log1p(sums.fallen));
        const float move = missing * (1 + sums.fallen) / sums.density;
        distance += std::max(0.0F, move);
        if (!(move > kNewtonPrecision * distance)) break;
    }
    return distance;
}

/// Both sums and this have the factor exp(-least_ t), which is left out.
SampledSpectrum FreePath::left_at(float distance) const {
    SampledSpectrum left;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        if (!(shares_[i] > 0)) continue;
        left[i] = left_of(medium_.scattering[i] - least_, distance) *
                  left_of(medium_.absorption[i], distance);
    }
    return left;
}

SampledSpectrum FreePath::passed(float distance) const {
    return left_at(distance) / (1 + sums_at(distance).fallen);
}

SampledSpectrum FreePath::scattered(float distance) const {
    return left_at(distance) * medium_.scattering / sums_at(distance).density;
}

Flight fly(const SampledMedium& medium, const Ray& way, const SampledSpectrum& carried, float u) {
    const FreePath path(medium, carried);
    const float whole = amount(medium, way);
    if (!(u < path.chance(whole))) return {false, way.length, path.passed(whole)};
    const float flown = std::min(path.distance_at(u), whole);
    return {true, distance_at(medium, way, flown), path.scattered(flown)};
}

}  // namespace sunfleck::engine
