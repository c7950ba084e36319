// Importons: random walks from the visible points to the lights, which find emission that may be
// visible.
//
// In:  the visible points, some lights. Out: emission of paths that come near the visible points,
// weighted by approximate flux. Glass is passed straight on the way to a light, and a walk may end
// behind a gather disc: what is found is a guide sample for the emission guide
// (guide/emission_guide.h) and no part of a picture.
// Source: Jensen, Importance driven path tracing using the photon map (1995); Peter and Pietrek,
// Importance driven construction of photon maps (1998).
#pragma once

#include "guide/guide_source.h"
#include "photon/light_stratum.h"

namespace sunfleck::engine {

/// Traces importons begin .. end - 1.
/// @param photon_context  with at least one visible point.
/// @param pass  names the random numbers.
WalkedEmission trace_importons(const PhotonContext& photon_context, const LightChoice& lights,
                               PassId pass, const PathRange& walks);

/// Returns the mean flux that an importon finds of all lights, direct light at the visible points
/// included, in the unit of the guide samples' weights.
double flux_seen(const PhotonContext& photon_context, PassId pass);

}  // namespace sunfleck::engine
