// PortalImage: a rectified environment map, in which a portal is an axis-aligned rectangle from
// every point.
//
// In:  radiance by direction. Out: radiance that is constant in cells, with sampling of cells in
// such a rectangle by their light. A direction w of the portal's frame (z out to the environment)
// is at u = half(w.x / w.z), v = half(w.y / w.z) with half(t) = (1 + t / (1 + |t|)) / 2: even in
// angles within a factor of two, and free of transcendental functions.
// Source: Bitterli, Novak and Jarosz, Portal-Masked Environment Map Sampling (EGSR 2015), whose map
// is by angles.
#pragma once

#include "light/light_image.h"

#include <functional>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// A direction, and the scale of areas of the map there.
struct PortalDirection {
    Vec3d w;                 // unit, in the portal's frame, w.z > 0
    double solid_angle = 0;  // per unit of u times v
};

PortalDirection portal_direction(const Vec2d& uv);
/// Maps a direction of any length to the unit square. @param w  with w.z > 0.
Vec2d portal_place(const Vec3d& w);

/// A rectangle of the unit square.
struct PortalWindow {
    Vec2d low;
    Vec2d high;
    bool contains(const Vec2d& uv) const {
        return uv.x >= low.x && uv.x <= high.x && uv.y >= low.y && uv.y <= high.y;
    }
};

class PortalImage {
public:
    /// Returns linear sRGB for a direction of the portal's frame.
    using Sky = std::function<Vec3(const Vec3d& w)>;

    /// @param side  cells per axis: each takes 4 x 4 samples of the environment, weighted by solid
    /// angle.
    PortalImage(int side, const Sky& sky);

    /// Returns the light through a unit of the portal's area: radiance times cosine over the
    /// hemisphere.
    const LightImage& through() const { return through_; }

    struct Drawn {
        Vec2d uv;
        TexelLight light;
        double density = 0;  // over the unit square
    };
    /// Samples by luminance times solid angle within the window; nothing if the window is black.
    /// @param u  in (0,1)^2.
    std::optional<Drawn> draw(const PortalWindow& window, const Vec2d& u) const;
    /// Returns the density of draw() at a point of the window.
    double density(const PortalWindow& window, const Vec2d& uv) const;

private:
    double mass(double x, double y) const;
    double mass(const PortalWindow& window) const;
    double weight(int column, int row) const;

    LightImage through_;
    int side_;
    /// Summed-area table: the weights of all cells left of and above each cell corner, side_ + 1
    /// squared.
    std::vector<double> sums_;
};

}  // namespace sunfleck::engine
