// The colour spaces of FLIP: linear RGB to the opponent space YCxCz and back, and to CIELAB with
// Hunt's effect.
//
// Source: Andersson et al., FLIP: A Difference Evaluator for Alternating Images (HPG 2020),
// sections 4.1 and 4.2; matrix of linear sRGB from the primaries and D65 as its authors' program
// rounds them.
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine::flip {

using Rows = std::array<Vec3, 3>;

inline const Rows kXyzOfRgb = {Vec3(0.412386563F, 0.357591491F, 0.180450491F),
                               Vec3(0.212636822F, 0.715182982F, 0.0721801965F),
                               Vec3(0.0193306202F, 0.119197164F, 0.950372587F)};
inline const Rows kRgbOfXyz = {Vec3(3.241003275F, -1.537398934F, -0.498615861F),
                               Vec3(-0.969224334F, 1.875930071F, 0.041554224F),
                               Vec3(0.055639423F, -0.204011202F, 1.057148933F)};

inline Vec3 times(const Rows& rows, const Vec3& v) {
    return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)};
}

/// XYZ of R = G = B = 1.
inline Vec3 white() {
    return times(kXyzOfRgb, Vec3(1));
}

/// XYZ relative to white.
inline Vec3 relative_xyz(const Vec3& rgb) {
    return times(kXyzOfRgb, rgb) / white();
}

/// YCxCz of linear RGB: CIELAB without its cube root.
inline Vec3 opponent_of_rgb(const Vec3& rgb) {
    const Vec3 r = relative_xyz(rgb);
    return {116 * r.y - 16, 500 * (r.x - r.y), 200 * (r.y - r.z)};
}

inline Vec3 rgb_of_opponent(const Vec3& ycc) {
    const float y = (ycc.x + 16) / 116;
    return times(kRgbOfXyz, Vec3(y + ycc.y / 500, y, y - ycc.z / 200) * white());
}

/// CIELAB of linear RGB within [0,1], a and b weighed by lightness (Hunt's effect).
inline Vec3 hunt_lab(const Vec3& rgb) {
    const auto curve = [](float t) {
        constexpr float kDelta = 6.0F / 29;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0F / 29;
    };
    const Vec3 r = relative_xyz(rgb);
    const float l = 116 * curve(r.y) - 16;
    const float weight = 0.01F * l;
    return {l, weight * 500 * (curve(r.x) - curve(r.y)), weight * 200 * (curve(r.y) - curve(r.z))};
}

/// HyAB, a distance for large differences: steps of lightness plus those of hue and chroma.
inline float hyab(const Vec3& a, const Vec3& b) {
    const Vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

inline Vec3 clamp01(const Vec3& v) {
    return {std::clamp(v.x, 0.0F, 1.0F), std::clamp(v.y, 0.0F, 1.0F), std::clamp(v.z, 0.0F, 1.0F)};
}

}  // namespace sunfleck::engine::flip
