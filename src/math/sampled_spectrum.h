// Eight wavelengths of a pass, side by side: a plain array that compilers turn into vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck {

inline constexpr std::size_t kLanes = 8;

/// One value per wavelength lane of the pass.
struct alignas(16) Spectrum {
    std::array<float, kLanes> lane{};

    Spectrum() = default;
    explicit Spectrum(float all) { lane.fill(all); }

    float operator[](std::size_t i) const { return lane[i]; }
    float& operator[](std::size_t i) { return lane[i]; }

    Spectrum& operator+=(const Spectrum& b) {
        for (std::size_t i = 0; i < kLanes; ++i) lane[i] += b.lane[i];
        return *this;
    }
    Spectrum& operator-=(const Spectrum& b) {
        for (std::size_t i = 0; i < kLanes; ++i) lane[i] -= b.lane[i];
        return *this;
    }
    Spectrum& operator*=(const Spectrum& b) {
        for (std::size_t i = 0; i < kLanes; ++i) lane[i] *= b.lane[i];
        return *this;
    }
    Spectrum& operator/=(const Spectrum& b) {
        for (std::size_t i = 0; i < kLanes; ++i) lane[i] /= b.lane[i];
        return *this;
    }
    Spectrum& operator*=(float b) {
        for (std::size_t i = 0; i < kLanes; ++i) lane[i] *= b;
        return *this;
    }
    Spectrum& operator/=(float b) { return *this *= 1 / b; }

    friend Spectrum operator+(Spectrum a, const Spectrum& b) { return a += b; }
    friend Spectrum operator-(Spectrum a, const Spectrum& b) { return a -= b; }
    friend Spectrum operator*(Spectrum a, const Spectrum& b) { return a *= b; }
    friend Spectrum operator/(Spectrum a, const Spectrum& b) { return a /= b; }
    friend Spectrum operator*(Spectrum a, float b) { return a *= b; }
    friend Spectrum operator*(float a, Spectrum b) { return b *= a; }
    friend Spectrum operator/(Spectrum a, float b) { return a /= b; }
    friend bool operator==(const Spectrum&, const Spectrum&) = default;

    float max() const { return *std::max_element(lane.begin(), lane.end()); }
    float min() const { return *std::min_element(lane.begin(), lane.end()); }
    /// Lanes far apart first: four sums side by side.
    float sum() const {
        constexpr std::size_t kHalf = kLanes / 2;
        std::array<float, kHalf> pairs;
        for (std::size_t i = 0; i < kHalf; ++i) pairs[i] = lane[i] + lane[i + kHalf];
        return (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]);
    }
    float mean() const { return sum() / static_cast<float>(kLanes); }
    bool is_zero() const { return *this == Spectrum(); }
    bool is_finite() const {
        return std::all_of(lane.begin(), lane.end(), [](float v) { return std::isfinite(v); });
    }
    /// All lanes zero but `i`.
    static Spectrum only(std::size_t i, float value) {
        Spectrum s;
        s.lane[i] = value;
        return s;
    }
};

inline Spectrum sqrt(const Spectrum& a) {
    Spectrum r;
    for (std::size_t i = 0; i < kLanes; ++i) r[i] = std::sqrt(a[i]);
    return r;
}

/// The dispersion state of one path: which lane a dispersive refraction would keep (chosen by the
/// path's own slot, uniform over lanes), and whether one has.
struct LaneChoice {
    std::size_t chosen = 0;  // below kLanes
    bool single = false;     // the other lanes of the throughput are zero already
};

/// The lane that a number of (0,1) stands for, all alike.
inline std::size_t lane_of(double u) {
    return std::min(kLanes - 1, static_cast<std::size_t>(u * static_cast<double>(kLanes)));
}

/// Keeps the chosen lane of a throughput, times their number; does nothing if that was done before.
inline void keep_lane(Spectrum& throughput, LaneChoice& lanes) {
    if (lanes.single) return;
    throughput =
        Spectrum::only(lanes.chosen, throughput[lanes.chosen] * static_cast<float>(kLanes));
    lanes.single = true;
}

}  // namespace sunfleck
