// Where lights are, where to they shine and how brightly: bounds for choosing between them.
//
// Source: Conty Estevez and Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting
// (2018): boxes and cones, and the measure by which sets of them are split.
#pragma once

#include "geometry/bounds.h"
#include "light/light.h"

#include <optional>
#include <span>

namespace sunfleck::engine {

/// A point that light is wanted at.
struct Receiver {
    Vec3 position{0};
    /// Unit, towards the half space that light can come from; zero: from everywhere.
    Vec3 normal{0};
};

/// Of one light or of many.
struct LightBounds {
    Bounds box;
    /// Normals (of points: directions) lie in the cone around the axis with this cosine; from each,
    /// light goes out within a further angle.
    Vec3d axis{0, 0, 1};
    double cos_spread = 1;
    double cos_reach = 0;
    double intensity = 0;  // in the brightest direction, summed: luminous, per steradian
    bool two_sided = false;
};

/// @param weight  Light::power() times the luminance of its curve; positive.
/// @return nothing for lights that are infinitely far away.
std::optional<LightBounds> bounds_of(const Light& light, double weight);

/// The bounds of all. @param parts  at least one.
LightBounds merged(std::span<const LightBounds> parts);

/// How much light of such bounds a random ray may meet: surface area times solid angle times
/// intensity.
double measure_of(const LightBounds& bounds);

/// Bounds in the form in which they are asked.
class LightCluster {
public:
    LightCluster() = default;
    explicit LightCluster(const LightBounds& bounds);

    /// About the light that arrives, unhindered; zero only if none can arrive.
    double importance(const Receiver& at) const;

private:
    Vec3d center_{0};
    double radius2_ = 0;  // of the sphere around the box
    Vec3d axis_{0};
    double cos_spread_ = 1;
    double sin_spread_ = 0;
    double cos_reach_ = 0;
    double intensity_ = 0;
    bool two_sided_ = false;
};

}  // namespace sunfleck::engine
