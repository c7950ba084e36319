// Caster samples: emission that arrives at casters, the surfaces that may bend light into a
// caustic.
//
// In:  a scene, some lights. Out: guide samples (guide/emission_guide.h), no part of a picture.
// Where camera paths bring what diffuse surfaces send on first, each photon that counts hits a
// caster first. Their samples find it however large the scene around the casters is.
// Source: projection maps: Jensen, Global illumination using photon maps (1996).
#pragma once

#include "photon/light_stratum.h"
#include "random_numbers/path_range.h"

namespace sunfleck::engine {

/// Returns emission towards points on casters, weighted by unoccluded flux; none without casters.
/// @param pass  names the random numbers. @param tries  one sample each, if it succeeds.
std::vector<WeightedEmission> caster_samples(const PassScene& scene, const LightChoice& lights,
                                             PassId pass, const PathRange& tries);

}  // namespace sunfleck::engine
