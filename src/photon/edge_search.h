// Search for gaps: emission that passes close to an edge of a surface.
//
// In:  the scene's surfaces, some lights. Out: emission of light that arrives at points by edges of
// triangles and patches, and goes on from there. A hole in a wall has edges, and so have a door
// that is ajar and the slats of a blind: however narrow a gap is, and however far from what is
// seen, points by its edges find it. Which of it is visible, paths must tell (chains/pilot.h).
#pragma once

#include "photon/light_stratum.h"
#include "random_numbers/emission_point.h"
#include "random_numbers/path_range.h"

#include <vector>

namespace sunfleck::engine {

/// Tries begin .. end - 1, a point by an edge each. @param pass  names their random numbers.
/// @return what arrives, all of the same weight: none in a scene without edges.
std::vector<WeightedEmission> emission_past_edges(const PhotonContext& view,
                                                  const LightChoice& lights, PassId pass,
                                                  const PathRange& tries);

}  // namespace sunfleck::engine
