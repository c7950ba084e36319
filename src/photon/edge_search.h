// Edge search: samples emission that passes close to edges of surfaces, to find narrow gaps.
//
// In:  the surfaces of the scene, some lights. Out: emission of light that arrives at points next
// to edges of triangles and patches, and continues from there. A hole in a wall has edges, and so
// have a door that is ajar and the slats of a blind: points next to edges find a gap, however
// narrow it is and however far from the visible points. Photon paths decide which emission is
// visible (chains/pilot.h).
#pragma once

#include "photon/light_stratum.h"
#include "random_numbers/emission_point.h"
#include "random_numbers/path_range.h"

#include <vector>

namespace sunfleck::engine {

/// Samples tries begin .. end - 1, each with a point next to an edge.
/// @param pass  names the random numbers.
/// @return the emission that arrives, with equal weights; none in a scene without edges.
std::vector<WeightedEmission> emission_past_edges(const PhotonContext& photon_context,
                                                  const LightChoice& lights, PassId pass,
                                                  const PathRange& tries);

}  // namespace sunfleck::engine
