// LightBounds: bounds of lights in position, direction and intensity, for many-light sampling.
//
// Source: Conty Estevez and Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting
// (2018): boxes and cones, and the cost by which sets are split.
#pragma once

#include "geometry/bounds.h"
#include "light/light.h"

#include <optional>
#include <span>

namespace sunfleck::engine {

/// A point to be lit.
struct Receiver {
    Vec3 position{0};
    /// Unit normal of the half space that light can come from; zero for all directions.
    Vec3 normal{0};
};

/// Bounds of one light or of several.
struct LightBounds {
    Bounds box;
    /// The normals (of points: directions) lie in a cone around the axis with this cosine; from
    /// each, light is emitted within a further angle.
    Vec3d axis{0, 0, 1};
    double cos_spread = 1;
    double cos_reach = 0;
    double intensity = 0;  // in the brightest direction, summed: luminous, per steradian
    bool two_sided = false;
};

/// @param weight  Light::power() times the luminance of its spectrum; positive.
/// @return nothing for lights that are infinitely far away.
std::optional<LightBounds> bounds_of(const Light& light, double weight);

/// Returns the bounds of all. @param parts  at least one.
LightBounds merged(std::span<const LightBounds> parts);

/// Returns the cost of such bounds for splitting: surface area times solid angle times intensity.
double measure_of(const LightBounds& bounds);

/// Bounds prepared for evaluation of their importance.
class LightCluster {
public:
    LightCluster() = default;
    explicit LightCluster(const LightBounds& bounds);

    /// Returns an estimate of the unoccluded light at a point; zero only if none can arrive.
    double importance(const Receiver& at) const;

private:
    Vec3d center_{0};
    double radius2_ = 0;  // of the bounding sphere of the box
    Vec3d axis_{0};
    double cos_spread_ = 1;
    double sin_spread_ = 0;
    double cos_reach_ = 0;
    double intensity_ = 0;
    bool two_sided_ = false;
};

}  // namespace sunfleck::engine
