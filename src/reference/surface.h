// What scatters at a vertex of a reference path, and what that does to the path's wavelengths.
#pragma once

#include "scene/pass_scene.h"

namespace sunfleck {

/// The Bsdf at a hit, as the path sees it: where lanes part and the surface is not smooth, the path
/// keeps its chosen lane from here on; a path of one lane sees that lane's Bsdf.
/// @param hit  its shading normal and tangent are bent where the material has a relief.
inline Bsdf met_bsdf(const PassScene& scene, Hit& hit, Spectrum& throughput, LaneChoice& lanes) {
    std::optional<Bsdf> room;
    const Bsdf& bsdf = scene.bsdf_at(hit, room);
    if (!is_dispersive(bsdf)) return bsdf;
    if (scattering(bsdf) != Scattering::specular) keep_lane(throughput, lanes);
    return lanes.single ? for_lane(bsdf, lanes.chosen) : bsdf;
}

}  // namespace sunfleck
