// Single photon paths for tests: squares under a sun, and the photons that each path leaves.
#pragma once

#include "photon/tracer.h"

#include <vector>

namespace sunfleck::engine {

/// A square of side 4 at height z, facing up.
inline ShapeDescription square(float z, std::uint32_t material) {
    TriangleMesh mesh;
    mesh.positions = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

/// A sun straight from above; materials 0: grey 0.5, 1: glass, 2: white, 3: rough metal.
inline SceneDescription sunny(std::vector<ShapeDescription> shapes) {
    SceneDescription scene;
    scene.materials = {
        DiffuseMaterial{}, ThinDielectricMaterial{}, DiffuseMaterial{Spectrum::constant(1)},
        ConductorMaterial{Spectrum::constant(0.2F), Spectrum::constant(4), {}, {0.3F, 0.3F}}};
    scene.shapes = std::move(shapes);
    scene.lights = {DistantLight{Spectrum::constant(1), {0, 0, -1}}};
    return scene;
}

struct Path {
    std::vector<Photon> photons;
    PathEnd end = PathEnd::no_light;
    std::uint64_t rays = 0;
};

inline std::vector<Path> paths_of(const SceneDescription& description,
                                  const TransportSettings& transport, std::uint32_t count = 2000) {
    const Scene scene(description);
    const PassScene pass(scene, {1, 0});
    const PhotonTracer tracer(pass, transport);
    std::vector<Path> paths(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        Path& path = paths[i];
        path.end = tracer.trace(
            IndependentReader(PassId{1, 0}.stream(Purpose::test, i)),
            [&](const Photon& photon) {
                path.photons.push_back(photon);
                return true;
            },
            path.rays);
    }
    return paths;
}

/// All light by photons.
inline std::vector<Path> paths_of(const SceneDescription& description, int max_depth,
                                  std::uint32_t count = 2000) {
    return paths_of(description, TransportSettings{DirectLight::photons, max_depth}, count);
}

}  // namespace sunfleck::engine
