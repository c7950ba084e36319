// Surfaces between media: along any line the medium behind one is that before the next.
#pragma once

#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunfleck::engine {

/// Numbers of media that most of these scenes have; others follow from 2.
inline constexpr int kAir = 0;
inline constexpr int kGlass = 1;

/// A mesh between two media, named by numbers.
struct Interface {
    Mesh mesh;
    int back = 0;
    int front = 0;  // where its normals point to
};

struct Crossing {
    double distance = 0;
    int before = 0;
    int after = 0;
};

/// All crossings of a ray with the surfaces, from near to far.
inline std::vector<Crossing> crossings_of(const std::vector<Interface>& surfaces,
                                          const Vec3d& origin, const Vec3d& direction) {
    std::vector<Crossing> crossings;
    for (const Interface& surface : surfaces)
        for (const MeshHit& h : all_hits(surface.mesh, origin, direction))
            crossings.push_back({h.distance, h.from_front ? surface.front : surface.back,
                                 h.from_front ? surface.back : surface.front});
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
    return crossings;
}

/// The medium behind a crossing is the medium before the next; both ends are in `outside`.
inline void expect_consistent(const std::vector<Crossing>& crossings, int outside) {
    int medium = outside;
    for (const Crossing& crossing : crossings) {
        ASSERT_EQ(crossing.before, medium) << "at " << crossing.distance;
        medium = crossing.after;
    }
    ASSERT_EQ(medium, outside);
}

}  // namespace sunfleck::engine
