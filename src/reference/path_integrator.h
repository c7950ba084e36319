// Path tracing: the reference that photon mapping is tested against where both converge.
//
// Written apart from the camera pass, on purpose: it shares scene, bsdfs and lights, but neither
// its direct light, nor its numbers, nor its idea of who brings what. It brings no caustics of
// point, spot and distant lights: no path from the eye can find them. Source: Kajiya 1986; multiple
// importance sampling by the balance heuristic, Veach 1997, ch. 9.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "aovs/transport.h"
#include "camera/pixel_window.h"
#include "scene/pass_scene.h"

namespace sunfleck::engine {

struct ReferencePass {
    const PassScene& scene;
    const TransportSettings& transport;  // max_depth; `direct` does not matter here
    PixelWindow window;
    PassId id;
};

/// Adds one path a pixel to the total of the image, pixels row by row.
void trace_reference_paths(const ReferencePass& pass, PassImage& image, Statistics& statistics);
/// The same, of light that nothing scatters: emitters as the camera sees them.
void trace_emitters(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
