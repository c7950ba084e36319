// SampledSpectrum: values at the eight wavelengths of a pass, in a plain array for vectorisation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck::engine {

inline constexpr std::size_t kWavelengths = 8;

/// One value per wavelength of the pass (pbrt-v4).
struct alignas(16) SampledSpectrum {
    std::array<float, kWavelengths> values{};

    SampledSpectrum() = default;
    explicit SampledSpectrum(float all) { values.fill(all); }

    float operator[](std::size_t i) const { return values[i]; }
    float& operator[](std::size_t i) { return values[i]; }

    SampledSpectrum& operator+=(const SampledSpectrum& b) {
        for (std::size_t i = 0; i < kWavelengths; ++i) values[i] += b.values[i];
        return *this;
    }
    SampledSpectrum& operator-=(const SampledSpectrum& b) {
        for (std::size_t i = 0; i < kWavelengths; ++i) values[i] -= b.values[i];
        return *this;
    }
    SampledSpectrum& operator*=(const SampledSpectrum& b) {
        for (std::size_t i = 0; i < kWavelengths; ++i) values[i] *= b.values[i];
        return *this;
    }
    SampledSpectrum& operator/=(const SampledSpectrum& b) {
        for (std::size_t i = 0; i < kWavelengths; ++i) values[i] /= b.values[i];
        return *this;
    }
    SampledSpectrum& operator*=(float b) {
        for (std::size_t i = 0; i < kWavelengths; ++i) values[i] *= b;
        return *this;
    }
    SampledSpectrum& operator/=(float b) { return *this *= 1 / b; }

    friend SampledSpectrum operator+(SampledSpectrum a, const SampledSpectrum& b) { return a += b; }
    friend SampledSpectrum operator-(SampledSpectrum a, const SampledSpectrum& b) { return a -= b; }
    friend SampledSpectrum operator*(SampledSpectrum a, const SampledSpectrum& b) { return a *= b; }
    friend SampledSpectrum operator/(SampledSpectrum a, const SampledSpectrum& b) { return a /= b; }
    friend SampledSpectrum operator*(SampledSpectrum a, float b) { return a *= b; }
    friend SampledSpectrum operator*(float a, SampledSpectrum b) { return b *= a; }
    friend SampledSpectrum operator/(SampledSpectrum a, float b) { return a /= b; }
    friend bool operator==(const SampledSpectrum&, const SampledSpectrum&) = default;

    float max() const { return *std::max_element(values.begin(), values.end()); }
    float min() const { return *std::min_element(values.begin(), values.end()); }
    /// Adds distant wavelengths first, as four independent sums.
    float sum() const {
        constexpr std::size_t kHalf = kWavelengths / 2;
        std::array<float, kHalf> pairs;
        for (std::size_t i = 0; i < kHalf; ++i) pairs[i] = values[i] + values[i + kHalf];
        return (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]);
    }
    float mean() const { return sum() / static_cast<float>(kWavelengths); }
    bool is_zero() const { return *this == SampledSpectrum(); }
    bool is_finite() const {
        return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
    }
    /// Returns a spectrum that is zero except at wavelength `i`.
    static SampledSpectrum only(std::size_t i, float value) {
        SampledSpectrum s;
        s.values[i] = value;
        return s;
    }
};

inline SampledSpectrum sqrt(const SampledSpectrum& a) {
    SampledSpectrum r;
    for (std::size_t i = 0; i < kWavelengths; ++i) r[i] = std::sqrt(a[i]);
    return r;
}

/// Hero wavelength of a path (Wilkie et al. 2014): the wavelength that a dispersive refraction
/// keeps, chosen uniformly by the path's own random number, and whether one has been kept.
struct HeroWavelength {
    std::size_t chosen = 0;  // below kWavelengths
    bool single = false;     // true if the secondary wavelengths are terminated: the throughput has
                             // one wavelength
};

/// Maps a number of (0,1) to a wavelength index, all with equal probability.
inline std::size_t hero_of(double u) {
    return std::min(kWavelengths - 1,
                    static_cast<std::size_t>(u * static_cast<double>(kWavelengths)));
}

/// Terminates the secondary wavelengths of a throughput and multiplies the hero wavelength by their
/// number. It has no effect the second time.
inline void terminate_secondary(SampledSpectrum& throughput, HeroWavelength& hero) {
    if (hero.single) return;
    throughput = SampledSpectrum::only(hero.chosen,
                                       throughput[hero.chosen] * static_cast<float>(kWavelengths));
    hero.single = true;
}

}  // namespace sunfleck::engine
