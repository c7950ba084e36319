// Bump maps and normal maps: they perturb the shading normal and leave the surface as it is.
//
// Source: Blinn, Simulation of Wrinkled Surfaces (SIGGRAPH 1978); differences and frames as in
// pbrt-v4 (Physically Based Rendering, 4th edition, section 10.5).
#pragma once

#include "geometry/derivatives.h"
#include "image/image.h"
#include "texture/texture.h"

#include <memory>
#include <variant>

namespace sunfleck::engine {

/// Displacement along the normal, in world units.
struct DisplacementMap {
    FloatTexture displacement;
};

/// A normal map: RGB in [0,1] encodes the normal in [-1,1], along dp/du, the bitangent and the
/// outside.
struct NormalMap {
    std::shared_ptr<const Image> image;
    Mapping mapping = UvMapping{};
    Wraps wraps = Wrap::repeat;
    float strength = 1;      // factor of the slopes
    bool follows_v = false;  // the bitangent is on the side of dp/dv (glTF), not of normal x dp/du
};

using BumpMap = std::variant<std::monostate, DisplacementMap, NormalMap>;

inline bool is_flat(const BumpMap& bump_map) {
    return std::holds_alternative<std::monostate>(bump_map);
}

/// Perturbs the shading normal and the tangent of a hit. The shading normal stays on the side of
/// the geometric one; if the map gives no valid normal, the hit is unchanged.
/// @param origin  of rendering space, in the world.
void perturb_shading(const BumpMap& bump_map, const SurfaceDerivatives& surface, Hit& hit,
                     const Vec3d& origin = Vec3d(0));

}  // namespace sunfleck::engine
