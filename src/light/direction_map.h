// DirectionMap: how an image covers the sphere of directions, z up.
//
// Maps are continuous in the place, and equal areas of a row of texels have equal solid angles, so
// that a LightImage with the map's shares samples directions by luminance, exactly.
// Source: Clarberg, Fast Equal-Area Mapping of the (Hemi)Sphere (2008), for the square map.
#pragma once

#include "math/vector.h"

#include <memory>
#include <optional>
#include <vector>

namespace sunfleck::engine {

class DirectionMap {
public:
    /// The square octahedral map of equal areas (uniform_sphere() in math/warp.h).
    DirectionMap() = default;
    /// Returns the map of latitude and longitude: +z is the upper edge, and the azimuth from +x
    /// over +y goes from the left edge to the right. Within a row the height z is linear.
    static DirectionMap latitude_longitude(int rows);

    /// Returns a unit vector. @param place  in the unit square, y down.
    Vec3d direction(const Vec2d& place) const;
    /// Inverts direction(), within 1e-7. @param w  unit vector.
    Vec2d place(const Vec3d& w) const;
    /// Returns the solid angle of a row of texels over the mean of all rows.
    double share(int row) const;
    bool has_equal_areas() const { return !heights_; }

private:
    /// z at the ends of rows, from 1 to -1; null for the square map.
    std::shared_ptr<const std::vector<double>> heights_;
};

/// Returns the map of an image by its shape: square, or twice as wide as high; none for others.
std::optional<DirectionMap> map_of_size(const Vec2i& size);

}  // namespace sunfleck::engine
