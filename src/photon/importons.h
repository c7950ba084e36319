// Walks from what is seen to the lights: which emission may be visible, found from the other end.
//
// In:  the view, some lights. Out: emission of paths that come near to the view or into it,
// weighted by about the flux that they bring. Glass is passed straight on the way to a light, and a
// walk may end on the dark side of a disc: what is found is a guide sample for emission guide
// (guide/emission_guide.h) and no part of a picture.
// Source: importance carried from the eye: Jensen, Importance driven path tracing using the photon
// map (1995); Peter and Pietrek, Importance driven construction of photon maps (1998).
#pragma once

#include "guide/guide_source.h"
#include "photon/light_stratum.h"

namespace sunfleck::engine {

/// Of walks begin .. end - 1. @param view  with one visible point at least. @param pass  names the
/// walks' random numbers.
WalkedEmission trace_importons(const PhotonContext& view, const LightChoice& lights, PassId pass,
                               const PathRange& walks);

/// The flux that a walk finds on average of all the scene's lights, direct light at the visible
/// points included, whoever brings it. In the unit of the guide samples' weights.
double flux_seen(const PhotonContext& view, PassId pass);

}  // namespace sunfleck::engine
