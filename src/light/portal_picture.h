// The sky behind a rectangular portal, as a picture in which the portal is a rectangle with upright
// sides wherever it is seen from.
//
// In:  radiance by direction. Out: the same, constant in cells; cells drawn within such a
// rectangle by what they send. A direction w of the portal's frame (z out to the sky) is at
// u = half(w.x / w.z), v = half(w.y / w.z) with half(t) = (1 + t / (1 + |t|)) / 2: within a factor
// of two even in angles, and all sums and quotients.
// Source: Bitterli, Novak and Jarosz, Portal-Masked Environment Map Sampling (EGSR 2015), whose
// map is by angles.
#pragma once

#include "light/light_picture.h"

#include <functional>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// A direction, and what the map does to areas there.
struct PortalDirection {
    Vec3d w;                 // unit, in the portal's frame, w.z > 0
    double solid_angle = 0;  // per unit of u times v
};

PortalDirection portal_direction(const Vec2d& uv);
/// Where a direction lies, of any length. @param w  with w.z > 0.
Vec2d portal_place(const Vec3d& w);

/// A rectangle of the unit square.
struct PortalWindow {
    Vec2d low;
    Vec2d high;
    bool contains(const Vec2d& uv) const {
        return uv.x >= low.x && uv.x <= high.x && uv.y >= low.y && uv.y <= high.y;
    }
};

class PortalPicture {
public:
    /// Linear sRGB from a direction of the portal's frame.
    using Sky = std::function<Vec3(const Vec3d& w)>;

    /// @param side  cells across: 4 x 4 looks at the sky in each, weighed by their solid angles.
    PortalPicture(int side, const Sky& sky);

    /// What passes a unit of the portal's area: radiance times cosine over the hemisphere.
    const LightPicture& through() const { return through_; }

    struct Drawn {
        Vec2d uv;
        TexelLight light;
        double density = 0;  // over the unit square
    };
    /// By luminance times solid angle, within the window; nothing if all there is black.
    /// @param u  in (0,1)^2.
    std::optional<Drawn> draw(const PortalWindow& window, const Vec2d& u) const;
    /// Density of draw() at a place of the window.
    double density(const PortalWindow& window, const Vec2d& uv) const;

private:
    double mass(double x, double y) const;
    double mass(const PortalWindow& window) const;
    double weight(int column, int row) const;

    LightPicture through_;
    int side_;
    /// Sums of weights of all cells left of and above each corner of a cell: side_ + 1 squared.
    std::vector<double> sums_;
};

}  // namespace sunfleck::engine
