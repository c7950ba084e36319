// Eight wavelengths of a pass, side by side: a plain array that compilers turn into vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck::engine {

inline constexpr std::size_t kWavelengths = 8;

/// One value per wavelength of the pass.
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
    /// Wavelengths far apart first: four sums side by side.
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
    /// All wavelengths zero but `i`.
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

/// The dispersion state of one path: which wavelength a dispersive refraction would keep (chosen by
/// the path's own slot, uniform over wavelengths), and whether one has.
struct HeroWavelength {
    std::size_t chosen = 0;  // below kWavelengths
    bool single = false;     // the other wavelengths of the throughput are zero already
};

/// The wavelength that a number of (0,1) stands for, all alike.
inline std::size_t hero_of(double u) {
    return std::min(kWavelengths - 1,
                    static_cast<std::size_t>(u * static_cast<double>(kWavelengths)));
}

/// Keeps the chosen wavelength of a throughput, times their number; does nothing if that was done
/// before.
inline void terminate_secondary(SampledSpectrum& throughput, HeroWavelength& hero) {
    if (hero.single) return;
    throughput = SampledSpectrum::only(hero.chosen,
                                       throughput[hero.chosen] * static_cast<float>(kWavelengths));
    hero.single = true;
}

}  // namespace sunfleck::engine
