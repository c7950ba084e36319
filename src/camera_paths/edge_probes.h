// Edge probes: how much surface lies in a gather disc.
//
// The estimate divides the photons of a disc by its area. Over the edge of a surface there are
// none, and on folds there is more surface than disc. So random points of the disc are probed, and
// its light is multiplied by an estimate of disc over surface. Where the surface is flat and has no
// edge, one pair of probes says so, and the factor is one. A cylinder in a medium loses what lies
// behind walls in the same way.
// In:  visible points of a pass. Out: their factor, for each radius.
// Source: reciprocals by series: Booth 2007, "Unbiased Monte Carlo Estimation of the Reciprocal of
// an Integral"; Qin et al. 2015, "Unbiased Photon Gathering for Light Transport Simulation".
// docs/method/method.md, edges of surfaces.
#pragma once

#include "core/random.h"
#include "scene/pass_scene.h"
#include "visible_points/visible_point.h"

#include <span>

namespace sunfleck::engine {

/// How to probe discs. Cylinders are always probed, as in a trial: walls are near some piece of
/// almost any ray.
enum class Probes {
    none,        // cylinders alone
    of_surface,  // hidden surface counts
    of_sight,    // hidden surface does not count: points need sight
    of_trial     // points need sight where a probe found hidden surface
};

/// Probes the kernels of one pixel. @param stream  of the pixel.
void probe_edges(const PassScene& pass, std::span<VisiblePoint> points, Probes probes,
                 RandomStream stream);

}  // namespace sunfleck::engine
