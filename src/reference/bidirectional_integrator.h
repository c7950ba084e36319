// Bidirectional path tracing, the reference for light that neither camera paths nor light paths
// find alone.
//
// It is independent of the photon pass, like all references. It computes all light except that of
// point, spot and distant lights on paths without two consecutive rough surfaces whose first
// surface from either end is specular, such as a caustic of the sun seen in a mirror: no strategy
// samples these.
// Source: Lafortune and Willems 1993; Veach 1997, ch. 10; weights: reference/mis_weights.h.
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// Adds a camera path and a light path per pixel, with all their connections, to the total.
void trace_bidirectional_paths(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
