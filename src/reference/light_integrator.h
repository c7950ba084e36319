// Light tracing: paths from the lights whose every vertex is looked at by the camera; the reference
// for what path tracing cannot find.
//
// Written apart from the photon pass, on purpose: it shares scene, bsdfs and lights, but neither
// discs, nor radii, nor numbers. It brings caustics of any light without bias, and shows no
// surface that is smooth, nor what is seen through one or in one: no chance meets the pixel then.
// Emitters themselves are seen by camera rays.
// Source: Dutre, Lafortune and Willems, Monte Carlo Light Tracing with Direct Computation of Pixel
// Intensities (1993); adjoint correction of shading normals: Veach 1997, section 5.3.2.
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// Adds `paths` light paths, and one camera ray a pixel, to the total of the image.
void trace_light_paths(const ReferencePass& pass, std::uint32_t paths, PassImage& image,
                       Statistics& statistics);

}  // namespace sunfleck::engine
