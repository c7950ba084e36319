// Light tracing: paths from the lights with a connection of every vertex to the camera, the
// reference for light that path tracing cannot find.
//
// It is independent of the photon pass on purpose: it shares scene, bsdfs and lights, but no gather
// discs, radii or random numbers. It computes caustics of any light without bias. It cannot show
// specular surfaces, nor what is seen through or in them, because no connection to the camera
// exists. Camera rays add emitters.
// Source: Dutre, Lafortune and Willems, Monte Carlo Light Tracing with Direct Computation of Pixel
// Intensities (1993); shading-normal correction: Veach 1997, section 5.3.2.
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// Adds `paths` light paths, and one camera ray per pixel, to the total of the image.
void trace_light_paths(const ReferencePass& pass, std::uint32_t paths, PassImage& image,
                       Statistics& statistics);

}  // namespace sunfleck::engine
