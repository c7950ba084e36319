// Media between surfaces: which one is where.
//
// A path stays in its medium until it leaves a surface with different media on its sides (pbrt-v4).
#pragma once

#include "math/vector.h"
#include "medium/medium.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Index into Media::all; 0 is empty space.
using MediumNumber = std::uint32_t;

/// The media on the two sides of a surface.
struct MediumSides {
    MediumNumber inside = 0;  // the side opposite to the normal
    MediumNumber outside = 0;

    /// Returns whether the media differ; if not, the surface does not define what is around it.
    bool differ() const { return inside != outside; }
    /// Returns the medium of a side.
    /// @param normal  geometric.
    /// @param direction  pointing away from the surface.
    MediumNumber towards(const Vec3& normal, const Vec3& direction) const {
        return normal.dot(direction) > 0 ? outside : inside;
    }
    friend bool operator==(const MediumSides&, const MediumSides&) = default;
};

/// Returns whether a medium absorbs or scatters.
bool acts(const Medium& medium);
/// Returns whether a medium emits: what absorbs nothing does not glow.
bool emits(const Medium& medium);

/// All media of a scene, and those in which paths start.
struct Media {
    std::vector<Medium> all{Medium()};
    MediumNumber at_camera = 0;
    std::vector<MediumSides> at_lights;  // per light; those beyond the end are in empty space

    /// Returns whether any medium acts.
    bool act() const;
};

}  // namespace sunfleck::engine
