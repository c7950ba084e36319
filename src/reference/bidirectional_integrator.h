// Bidirectional path tracing: the reference that finds what neither the eye nor the lights find
// alone.
//
// Written apart from the photon pass, as the other references are. It brings all light but that of
// point, spot and distant lights on paths where no two surfaces in a row are wide, and the first
// one met from either end is smooth: a caustic of the sun seen in a mirror. No strategy makes
// those. Source: Lafortune and Willems 1993; Veach 1997, ch. 10; weights: reference/mis_weights.h.
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// Adds, for each pixel, a camera path and a light path with all that joins them to the total.
void trace_bidirectional_paths(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
