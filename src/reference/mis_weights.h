// Weights of the strategies that make one path from the eye and from a light: balance heuristic.
//
// A path of n + 1 vertices is made by tracing t of them from the eye and s from the light. With
// P(s) the density of strategy s, its weight is P(s) / (sum of all P that can make the path). Each
// vertex keeps one sum over the strategies that would have met its own subpath sooner, so that no
// connection walks along the path.
// Source: Veach 1997, ch. 10.2; van Antwerpen, Recursive MIS Computation for Streaming BDPT on the
// GPU (2011). Sampling of lights as a strategy with a density of its own: Georgiev et al., Light
// Transport Simulation with Vertex Connection and Merging (2012).
#pragma once

#include <algorithm>

namespace sunfleck::engine {

/// A vertex as its own subpath made it.
struct PathWeights {
    /// With which the subpath made it, per m^2. At a light subpath's first vertex: times the
    /// density of its start, as EndDensities count it.
    double density = 1;
    /// Density, over that of its own subpath up to the vertex before, of the strategy that connects
    /// across the edge before the vertex; none where the vertex before scatters as a mirror does.
    double edge = 0;
    /// The same for all strategies that connect at edges further back, but for the density of
    /// leaving this vertex backwards.
    double earlier = 0;
};

/// Directions that leave a vertex, per sr: the one the subpath goes on in, and, were the path
/// traced from the other end, the one it came from. Of mirrors: the cosine, for a density that is
/// infinite both ways.
struct Departure {
    double forward = 0;
    double back = 0;
    bool is_delta = false;
};

/// Sum over all strategies that make this vertex from the other end, over the density of its own
/// subpath: still to be multiplied by the density (per m^2) with which that end would make it.
inline double from_other_end(const PathWeights& at, const Departure& leaving) {
    return ((leaving.is_delta ? 0 : at.edge) + leaving.back * at.earlier) / at.density;
}

/// The next vertex of a subpath. @param cosine_here, cosine_there  of the way between them with
/// the geometric normals. @param distance2  between them.
inline PathWeights next_weights(const PathWeights& here, const Departure& leaving,
                                double cosine_here, double cosine_there, double distance2) {
    constexpr double kLeast = 1e-200;  // keeps quotients finite
    return {std::max(leaving.forward * cosine_there / distance2, kLeast),
            leaving.is_delta ? 0.0 : 1.0, cosine_here / distance2 * from_other_end(here, leaving)};
}

/// Densities of a light's end of a path, all per sr as the vertex next to it sees the end (of
/// points and of parallel light: without a unit).
struct EndDensities {
    double hit = 0;      // one where a ray from the vertex can meet the light, else zero
    double direct = 0;   // of choosing and sampling it for direct light from there
    double emitted = 0;  // of choosing it and emitting that way, times that of the vertex, per m^2
};

/// Weights of the two strategies whose last step is at a light, at a vertex of the eye's subpath.
struct EndWeights {
    double met = 0;      // the ray met the light
    double sampled = 0;  // the light was sampled
};

/// @param leaving  towards the light.
inline EndWeights end_weights(const EndDensities& end, const PathWeights& vertex,
                              const Departure& leaving) {
    const double met = end.hit * leaving.forward;
    const double sampled = leaving.is_delta ? 0 : end.direct;
    const double total = met + sampled + end.emitted * from_other_end(vertex, leaving);
    if (!(total > 0)) return {};
    return {met / total, sampled / total};
}

/// The start of a light's subpath at its first vertex.
inline PathWeights first_of_light(const EndDensities& end) {
    return {std::max(end.emitted, 1e-200), end.direct, end.hit};
}

/// The start of the eye's subpath. @param density  of camera paths there, per m^2, if each pixel's
/// area has one. @param light_paths  for each of these.
inline PathWeights first_of_eye(double density, double light_paths) {
    return {std::max(density, 1e-200), light_paths, 0};
}

/// One of two vertices that are joined.
struct Joined {
    const PathWeights& weighing;
    const Departure& leaving;
    double from_other;  // the density with which the other end would make it, per m^2
};

/// Two wide vertices joined.
inline double connection_weight(const Joined& eye, const Joined& light) {
    return 1 / (1 + eye.from_other * from_other_end(eye.weighing, eye.leaving) +
                light.from_other * from_other_end(light.weighing, light.leaving));
}

/// A vertex of a light's subpath seen by the camera. @param at_light, light_paths  the two
/// arguments of first_of_eye(), there.
inline double light_image_weight(const PathWeights& light, const Departure& from_light,
                                 double at_light, double light_paths) {
    return 1 / (1 + at_light * from_other_end(light, from_light) / light_paths);
}

}  // namespace sunfleck::engine
