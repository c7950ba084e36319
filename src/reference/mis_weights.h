// MIS weights of bidirectional path tracing by the balance heuristic.
//
// A path of n + 1 vertices is sampled by t of them from the camera and s from the light. With P(s)
// the density of strategy s, its weight is P(s) / (sum of P of all strategies that can sample the
// path). Each vertex stores one sum over the strategies that would have connected earlier on its
// own subpath, so that no connection needs to visit all vertices.
// Source: Veach 1997, ch. 10.2; van Antwerpen, Recursive MIS Computation for Streaming BDPT on the
// GPU (2011). Light sampling as a strategy with a density of its own: Georgiev et al., Light
// Transport Simulation with Vertex Connection and Merging (2012).
// Equations: docs/method/references.md, eq. (36).
#pragma once

#include <algorithm>

namespace sunfleck::engine {

/// The densities at a vertex, as its own subpath sampled it.
struct PathWeights {
    /// Density per m^2 with which the subpath sampled the vertex. For the first vertex of a light
    /// subpath: times the density of its start, as in EndDensities.
    double density = 1;
    /// Density of the strategy that connects across the edge before the vertex, over that of its
    /// own subpath up to the previous vertex; zero if the previous vertex is specular.
    double edge = 0;
    /// Sum of these ratios for all strategies that connect at earlier edges, without the density of
    /// leaving this vertex backwards.
    double earlier = 0;
};

/// Densities of directions at a vertex, per sr: of the subpath's next direction, and of the reverse
/// one for a path from the other end. For specular vertices: the cosine, for a density that is
/// infinite both ways.
struct DirectionDensities {
    double forward = 0;
    double back = 0;
    bool is_delta = false;
};

/// Returns the sum over all strategies that sample this vertex from the other end, over the density
/// of its own subpath. The caller multiplies it by the density (per m^2) with which the other end
/// samples it.
inline double from_other_end(const PathWeights& at, const DirectionDensities& leaving) {
    return ((leaving.is_delta ? 0 : at.edge) + leaving.back * at.earlier) / at.density;
}

/// Returns the densities at the next vertex of a subpath.
/// @param cosine_here, cosine_there  of the segment with the geometric normals.
/// @param distance2  squared length of the segment.
inline PathWeights next_weights(const PathWeights& here, const DirectionDensities& leaving,
                                double cosine_here, double cosine_there, double distance2) {
    constexpr double kLeast = 1e-200;  // keeps quotients finite
    return {std::max(leaving.forward * cosine_there / distance2, kLeast),
            leaving.is_delta ? 0.0 : 1.0, cosine_here / distance2 * from_other_end(here, leaving)};
}

/// Densities of a path's end at a light, all per sr seen from the next vertex (for points and
/// parallel light: dimensionless).
struct EndDensities {
    double hit = 0;      // one if a ray from the vertex can hit the light, else zero
    double direct = 0;   // of next event estimation from there, choice of the light included
    double emitted = 0;  // of emission, choice included, times that of the vertex, per m^2
};

/// Weights of both strategies whose last step ends at a light, at a vertex of a camera subpath.
struct EndWeights {
    double hit = 0;      // the ray hit the light
    double sampled = 0;  // the light was sampled
};

/// @param leaving  towards the light.
inline EndWeights end_weights(const EndDensities& end, const PathWeights& vertex,
                              const DirectionDensities& leaving) {
    const double met = end.hit * leaving.forward;
    const double sampled = leaving.is_delta ? 0 : end.direct;
    const double total = met + sampled + end.emitted * from_other_end(vertex, leaving);
    if (!(total > 0)) return {};
    return {met / total, sampled / total};
}

/// Returns the start of a light subpath at its first vertex.
inline PathWeights first_of_light(const EndDensities& end) {
    return {std::max(end.emitted, 1e-200), end.direct, end.hit};
}

/// Returns the start of a camera subpath.
/// @param density  of camera paths at the vertex, per m^2, if each pixel's area has one.
/// @param light_paths  per camera path.
inline PathWeights first_of_camera(double density, double light_paths) {
    return {std::max(density, 1e-200), light_paths, 0};
}

/// One of two connected vertices.
struct Joined {
    const PathWeights& weights;
    const DirectionDensities& leaving;
    double from_other;  // density per m^2 with which the other end samples it
};

/// Returns the weight of a connection of two vertices.
inline double connection_weight(const Joined& camera, const Joined& light) {
    return 1 / (1 + camera.from_other * from_other_end(camera.weights, camera.leaving) +
                light.from_other * from_other_end(light.weights, light.leaving));
}

/// Returns the weight of a light vertex connected to the camera.
/// @param at_light, light_paths  arguments of first_of_camera() at the vertex.
inline double light_image_weight(const PathWeights& light, const DirectionDensities& from_light,
                                 double at_light, double light_paths) {
    return 1 / (1 + at_light * from_other_end(light, from_light) / light_paths);
}

}  // namespace sunfleck::engine
