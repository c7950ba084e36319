// A procedural scene as parts: which mesh is of what, and what stands between two points.
#pragma once

#include "core/random.h"
#include "mesh_checks.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sunfleck::engine {

struct Part {
    std::string material;
    Mesh mesh;
};

inline std::vector<Part> parts_of(const std::string& scene) {
    const std::vector<SceneFile> files = make_scene(scene);
    const std::vector<Mesh> meshes = scene_meshes(files);
    const std::vector<std::string> words = pbrt_words(files.at(0).bytes);
    std::vector<Part> parts;
    std::string material;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "NamedMaterial") material = words[i + 1].substr(1);
        if (words[i] == "Shape" && words[i + 1] != "\"sphere")
            parts.push_back({material, meshes.at(parts.size())});
    }
    return parts;
}

inline bool is_glass(const Part& part) {
    return part.material == "glass" || part.material == "pane";
}

struct Met {
    std::size_t opaque = 0;
    std::size_t glass = 0;
};

/// Faces between two points, of all parts that are not large (furniture, which only hides more).
inline Met faces_between(const std::vector<Part>& parts, const Vec3d& a, const Vec3d& b) {
    Met met;
    for (const Part& part : parts) {
        if (part.mesh.triangles.size() > 1000) continue;
        for (const MeshHit& hit : all_hits(part.mesh, a, b - a))
            if (hit.distance < 1) ++(is_glass(part) ? met.glass : met.opaque);
    }
    return met;
}

/// What a line towards the sun meets, from random points of a box.
inline void expect_sun_through_panes_only(const std::string& scene, const Vec3d& low,
                                          const Vec3d& high, const Vec3d& sun) {
    const std::vector<Part> parts = parts_of(scene);
    RandomStream random(5, Purpose::test, 0, 0);
    int lit = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d from(low.x + (high.x - low.x) * random.next(),
                         low.y + (high.y - low.y) * random.next(),
                         low.z + (high.z - low.z) * random.next());
        const Met met = faces_between(parts, from, from + sun * 30);
        if (met.opaque > 0) continue;
        ++lit;
        ASSERT_EQ(met.glass, 2) << from;
    }
    EXPECT_GT(lit, 60);
}

}  // namespace sunfleck::engine
