// What is known of a keyhole scene: how bright its picture is, and how rare a photon in view.
#pragma once

#include "procedural/keyhole.h"

namespace sunfleck {

struct KeyholeTruth {
    /// Mean luminance of the picture, which is white: R = G = B.
    double luminance;
    /// Share of uniform photon paths that land in view after the pane, for discs of no width.
    double visible_fraction;
};

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
KeyholeTruth keyhole_truth(const Keyhole& keyhole);

}  // namespace sunfleck
