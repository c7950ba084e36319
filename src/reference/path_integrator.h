// Path tracing, the reference for photon mapping where both converge.
//
// It is independent of the camera pass on purpose: it shares scene, bsdfs and lights, but not next
// event estimation, random numbers, or the path-space partition. It has no caustics of point, spot
// and distant lights, which no path from the camera can find.
// Source: Kajiya 1986; multiple importance sampling by the balance heuristic, Veach 1997, ch. 9.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "aovs/transport.h"
#include "camera/pixel_window.h"
#include "scene/pass_scene.h"

namespace sunfleck::engine {

struct ReferencePass {
    const PassScene& scene;
    const TransportSettings& transport;  // max_depth is used, `direct` is not
    PixelWindow window;
    PassId id;
};

/// Adds one path per pixel to the total of the image, in row-major order.
void trace_reference_paths(const ReferencePass& pass, PassImage& image, Statistics& statistics);
/// Adds light without scattering events: emitters seen by the camera.
void trace_emitters(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
