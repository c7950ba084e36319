// A scene with photon paths of very different lengths.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine::testing_support {

/// Two facing sheets with glass between, lit from within: paths of very different lengths.
inline SceneDescription lantern() {
    const auto square = [](float z, std::uint32_t material) {
        TriangleMesh mesh;
        mesh.positions = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        return ShapeDescription{{mesh, Matrix(), false}, material, {}, {}};
    };
    SceneDescription scene;
    scene.materials = {DiffuseMaterial{Spectrum::constant(0.8F)}, ThinDielectricMaterial{}};
    scene.shapes = {square(0, 0), square(1, 0), square(0.5F, 1)};
    scene.lights = {PointLight{Spectrum::constant(1), {0, 0, 0.25}}};
    return scene;
}

}  // namespace sunfleck::engine::testing_support
