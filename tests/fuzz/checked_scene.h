// What later stages take for granted of a scene, for fuzz targets of importers.
#pragma once

#include "scene/description.h"

#include <cstdlib>

/// Ends the program where a number points beyond its list.
inline void check_scene(const sunfleck::engine::SceneDescription& scene) {
    const auto check_shape = [&](const sunfleck::engine::ShapeDescription& shape) {
        if (shape.material >= scene.materials.size()) std::abort();
        const auto* mesh = std::get_if<sunfleck::engine::TriangleMesh>(&shape.placed.shape);
        if (!mesh) return;
        for (const auto& triangle : mesh->triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh->positions.size()) std::abort();
    };
    for (const auto& shape : scene.shapes) check_shape(shape);
    for (const auto& object : scene.objects)
        for (const auto& shape : object) check_shape(shape);
    for (const auto& instance : scene.instances)
        if (instance.object >= scene.objects.size()) std::abort();
}
