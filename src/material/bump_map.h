// Fine relief that shading sees and rays do not: bumps and normal maps bend the shading normal.
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

/// The surface is moved by so much along its normal, in the world's units.
struct Bumps {
    FloatTexture displacement;
};

/// R G B in [0,1] are the normal in [-1,1], along dp/du, across it, and outwards.
struct NormalMap {
    std::shared_ptr<const Image> image;
};

using Relief = std::variant<std::monostate, Bumps, NormalMap>;

inline bool is_flat(const Relief& relief) {
    return std::holds_alternative<std::monostate>(relief);
}

/// Bends the shading normal and the tangent of a hit. The shading normal stays on the side of the
/// geometric one; where the relief gives none, all stays as it was.
/// @param origin  of rendering space, in the world.
void bend(const Relief& relief, const SurfaceDerivatives& surface, Hit& hit,
          const Vec3d& origin = Vec3d(0));

}  // namespace sunfleck::engine
