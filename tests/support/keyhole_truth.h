// The true values of a keyhole scene: how bright its picture is, and how rare a photon in view.
#pragma once

#include "procedural/keyhole.h"

#include <cmath>

namespace sunfleck::engine::testing_support {

struct KeyholeTruth {
    /// Mean luminance of the picture, which is white: R = G = B.
    double luminance;
    /// Share of uniform photon paths that land in view after the pane, for discs of no width.
    double visible_fraction;
};

/// The terms of the integral that keyhole_truth() computes.
namespace keyhole_flux {

struct Node {
    double place;  // in (-1/2, 1/2)
    double weight;
};

/// Gauss-Legendre on an interval of length one.
inline constexpr std::array<Node, 5> kNodes = {{
    {-0.45308992296933200, 0.11846344252809454},
    {-0.26923465505284155, 0.23931433524968324},
    {0, 0.28444444444444444},
    {0.26923465505284155, 0.23931433524968324},
    {0.45308992296933200, 0.11846344252809454},
}};

/// The integral over a square around the origin. @param f  of x and y.
template <class F>
double over_square(double width, const F& f) {
    double sum = 0;
    for (const Node& x : kNodes)
        for (const Node& y : kNodes)
            sum += x.weight * y.weight * f(x.place * width, y.place * width);
    return sum * width * width;
}

/// Of light from a point by the cosine law: the share that falls on the rectangle between (0, 0)
/// and (a, b), `height` below; negative where one of a and b is.
inline double corner_share(double a, double b, double height) {
    const double p = std::sqrt(height * height + a * a);
    const double q = std::sqrt(height * height + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * kPiDouble);
}

inline double half_view(const KeyholeRoom& room) {
    return room.camera_height * std::tan(room.field_of_view / 2 * kPiDouble / 180);
}

/// Of light that leaves the pane at (x, y) from its middle.
inline double share_on_view(const KeyholeRoom& room, double x, double y) {
    const double half = half_view(room);
    const auto corner = [&](double a, double b) {
        return corner_share(a - x, b - y, room.pane_height);
    };
    return corner(half, half) - corner(-half, half) - corner(half, -half) + corner(-half, -half);
}

/// The integral of F dP, for irradiance one: the sun's rays are parallel, so each meets the pane
/// as far from its middle as the roof from the hole's.
inline double sun_on_view(const KeyholeRoom& room, double width) {
    return -room.way.z *
           over_square(width, [&](double x, double y) { return share_on_view(room, x, y); });
}

/// The same for radiance one. A ray meets the pane where it leads from lamp and hole.
inline double lamp_on_view(const KeyholeRoom& room, double width) {
    const Vec3d lamp = room.way * -room.lamp_distance;  // from the hole's middle
    const double below = (room.high[2] - room.pane_height) / lamp.z;
    return over_square(room.lamp_width, [&](double lamp_x, double lamp_y) {
        return over_square(width, [&](double x, double y) {
            const Vec3d down = Vec3d(x, y, 0) - (lamp + Vec3d(lamp_x, lamp_y, 0));
            const Vec3d on_pane = Vec3d(x, y, 0) + down * below;
            const double cosine2 = down.z * down.z / down.length2();
            return cosine2 / down.length2() *
                   share_on_view(room, on_pane.x - room.pane_x, on_pane.y);
        });
    });
}

/// For strength one.
inline double power(const KeyholeRoom& room, KeyholeLight light) {
    if (light == KeyholeLight::lamp) return kPiDouble * room.lamp_width * room.lamp_width;
    double diagonal2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double side = double{room.high.at(i)} - double{room.low.at(i)};
        diagonal2 += side * side;
    }
    return kPiDouble * diagonal2 / 4;
}

}  // namespace keyhole_flux

/// Within 1e-8 of the integral below (the scene's corners are floats: within 1e-6).
///
/// Light of flux dP that goes through a place of the hole meets the pane at a point y and leaves it
/// evenly below, as transmittance * dP. Of that a share F(y) falls on the view, a rectangle of area
/// A parallel to the pane (closed form below). Nothing comes back from anywhere, so the mean
/// radiance of the view is reflectance / pi * transmittance / A * integral of F dP, and the visible
/// fraction is transmittance / P * integral of F dP, P the light's whole power. With the sun dP is
/// irradiance * cosine * dA over the hole, and P irradiance times the disc of the scene's sphere;
/// with the lamp dP = L cos^2 / distance^2 dA dA' over hole and lamp, and P = pi L times its area.
/// Gauss-Legendre quadrature, five points a side: F is smooth, the pane far from the floor.
///
/// A ray that leaves a point by the cosine law falls on the rectangle between (0, 0) and (a, b), at
/// distance h below it, with the probability (Howell, A Catalog of Radiation Configuration Factors,
/// 1982, B-3)
///     (a / p atan(b / p) + b / q atan(a / q)) / 2 pi,  p^2 = h^2 + a^2,  q^2 = h^2 + b^2.
inline KeyholeTruth keyhole_truth(const Keyhole& keyhole) {
    const KeyholeRoom& room = kKeyholeRoom;
    const double on_view =
        room.transmittance * (keyhole.light == KeyholeLight::sun
                                  ? keyhole_flux::sun_on_view(room, keyhole.width)
                                  : keyhole_flux::lamp_on_view(room, keyhole.width));
    const double half = keyhole_flux::half_view(room);
    const double area = 4 * half * half;
    return {keyhole.strength * room.reflectance / kPiDouble * on_view / area,
            on_view / keyhole_flux::power(room, keyhole.light)};
}

}  // namespace sunfleck::engine::testing_support
