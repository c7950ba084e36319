// Primary samples of photon paths that aim at the hole of a keyhole scene, and at little else.
#pragma once

#include "photon/tracer.h"
#include "procedural/keyhole.h"
#include "random_numbers/primary_sample.h"
#include "scene/pass_scene.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine::testing_support {

/// A part of the unit square.
struct Window {
    Vec2d middle{0.5};
    Vec2d half{0.5};

    double area() const { return 4 * half.x * half.y; }
};

/// The part that holds all that leads to a square around (0, 0) of a plane.
/// @param to  from the unit square to the plane, smooth; by Newton's method with differences.
template <class To>
Window window_on_square(const To& to, double width) {
    constexpr double kStep = 1e-6;
    Vec2d u(0.5 + 1e-3, 0.5 + 2e-3);
    Vec2d half(0);
    for (int i = 0; i < 50; ++i) {
        const Vec2d at = to(u);
        const Vec2d by_x = (to(u + Vec2d(kStep, 0)) - at) / kStep;
        const Vec2d by_y = (to(u + Vec2d(0, kStep)) - at) / kStep;
        const double determinant = by_x.cross(by_y);
        const Vec2d step = Vec2d(at.cross(by_y), by_x.cross(at)) / determinant;
        u -= step * std::min(1.0, 0.05 / step.length());
        half = Vec2d(std::abs(by_y.x) + std::abs(by_y.y), std::abs(by_x.x) + std::abs(by_x.y)) *
               (width / 2 / std::abs(determinant));
    }
    return {u, half * 1.2};  // with some room, for the map bends
}

/// Two dimensions of the light in a window, all others anywhere.
struct Aim {
    Window window;
    EmissionDimension first;  // of the two
};

/// Valid as long as what it aims at.
class AimedReader {
public:
    AimedReader(const Aim& aim, const RandomStream& stream) : aim_(aim), anywhere_(stream) {}

    std::uint64_t operator()(std::uint32_t index) {
        const std::uint64_t drawn = anywhere_(index);
        const bool x = index == dimension(aim_.first);
        if (!x && index != dimension(aim_.first) + 1) return drawn;
        const auto& [middle, half] = aim_.window;
        const double place =
            (x ? middle.x : middle.y) + (2 * to_unit(drawn) - 1) * (x ? half.x : half.y);
        return static_cast<std::uint64_t>(std::ldexp(place, 64));
    }

private:
    const Aim& aim_;
    IndependentReader anywhere_;
};

/// At the hole: by the sun's places, or by the lamp's directions. Any place of the lamp then aims
/// somewhere around the hole.
inline Aim aim_at_hole(const Scene& scene, const Keyhole& keyhole) {
    const KeyholeRoom room = kKeyholeRoom;
    const bool sun = keyhole.light == KeyholeLight::sun;
    const auto on_roof = [&](const Vec2d& u) {
        const auto from = sample_emission(
            scene.lights()[0],
            sun ? EmissionDimensions{u.x, u.y, 0.5, 0.5} : EmissionDimensions{0.5, 0.5, u.x, u.y},
            scene.sphere());
        const Vec3d hole(0, 0, room.high[2]);
        const Vec3d origin = sun ? from.origin : hole - room.way * room.lamp_distance;
        const Vec3d at = origin + from.direction * ((room.high[2] - origin.z) / from.direction.z);
        return Vec2d(at.x, at.y);
    };
    const double width = keyhole.width + (sun ? 0 : room.lamp_width);
    return {window_on_square(on_roof, width),
            sun ? EmissionDimension::position_u : EmissionDimension::direction_u};
}

}  // namespace sunfleck::engine::testing_support
