// Where media glow: as their density says, or in a box around the shapes that name them.
#include "scene/medium_lights.h"

#include "geometry/measure.h"
#include "light/medium_light.h"
#include "scene/framing.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// A density of one everywhere.
struct Even {
    float value(const Voxel&) const { return 1; }
    std::optional<float> constant(const Voxel&, const Voxel&) const { return 1.0F; }
};

/// Returns bounds of all shapes on one of whose sides the medium is; of the scene if there are
/// none.
Bounds bounds_of_medium(const SceneDescription& scene, MediumNumber medium) {
    const auto has = [&](const ShapeDescription& shape) {
        return shape.media.differ() &&
               (shape.media.inside == medium || shape.media.outside == medium);
    };
    Bounds all;
    for (const ShapeDescription& shape : scene.shapes)
        if (has(shape)) all.extend(bounds_of(shape.placed));
    for (const InstanceDescription& instance : scene.instances)
        for (const ShapeDescription& shape : scene.objects[instance.object])
            if (has(shape))
                all.extend(image_of(bounds_of(shape.placed), Affine(instance.to_world)));
    return all.is_empty() ? bounds_of_scene(scene) : all;
}

/// Returns a density of one in a box; of a flat one, in a box of some thickness.
DensityGrid even_within(const Bounds& bounds) {
    const Vec3d size = bounds.max - bounds.min;
    const double least = std::max(1e-6 * size.length(), 1e-30);
    Affine box;
    box.x *= std::max(size.x, least);
    box.y *= std::max(size.y, least);
    box.z *= std::max(size.z, least);
    box.origin = bounds.min;
    constexpr Voxel kOneCell = {1, 1, 1};
    return DensityGrid(std::make_shared<const VoxelBlocks>(kOneCell, Even{}), {}, box).whole();
}

MediumLight light_of(const SceneDescription& scene, MediumNumber number) {
    const Medium& medium = scene.media.all[number];
    if (medium.glow->varies()) return {medium.absorption, number, *medium.glow->power};
    const Spectrum curve = medium.absorption.scaled(medium.glow->radiance.luminance());
    if (medium.density) return {curve, number, std::get<DensityGrid>(*medium.density).whole()};
    return {curve, number, even_within(bounds_of_medium(scene, number))};
}

}  // namespace

void add_medium_lights(SceneDescription& scene) {
    for (MediumNumber i = 0; i < scene.media.all.size(); ++i) {
        if (!emits(scene.media.all[i])) continue;
        scene.media.at_lights.resize(scene.lights.size());
        scene.stated_in.resize(scene.lights.size(), kNone);
        scene.lights.emplace_back(light_of(scene, i));
        scene.media.at_lights.push_back({i, i});
        scene.stated_in.push_back(kNone);
    }
}

}  // namespace sunfleck::engine
