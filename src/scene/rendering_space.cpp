// Bounds of the objects in the world, and translation of the scene.
#include "scene/rendering_space.h"

#include "geometry/measure.h"
#include "geometry/middle.h"

#include <type_traits>

namespace sunfleck::engine {
namespace {

using Shapes = std::vector<ShapeDescription>;

std::vector<Bounds> boxes_of(const Shapes& shapes) {
    std::vector<Bounds> boxes;
    boxes.reserve(shapes.size());
    for (const ShapeDescription& shape : shapes) boxes.push_back(bounds_of(shape.placed));
    return boxes;
}

/// Returns the world bounds of all instances and of shapes that do not emit, since a sun or a dome
/// says little about where the scene is; of emitting shapes if there are no others.
std::vector<Bounds> boxes_of_world(const SceneDescription& scene) {
    const std::vector<Bounds> of_shapes = boxes_of(scene.shapes);
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < of_shapes.size(); ++i)
        if (!scene.shapes[i].emission) boxes.push_back(of_shapes[i]);
    std::vector<Bounds> objects;
    for (const Shapes& object : scene.objects) {
        Bounds& box = objects.emplace_back();
        for (const Bounds& of_shape : boxes_of(object)) box.extend(of_shape);
    }
    for (const InstanceDescription& instance : scene.instances)
        boxes.push_back(image_of(objects[instance.object], Affine(instance.to_world)));
    return boxes.empty() ? of_shapes : boxes;
}

void move(Matrix& to_world, const Vec3d& by) {
    for (int axis = 0; axis < 3; ++axis) to_world[3][axis] += by[axis];
}

template <class L>
void move(L& light, const Vec3d& by) {
    if constexpr (requires { light.position; }) {
        light.position += by;
    } else if constexpr (requires { light.frame.origin; }) {
        light.frame.origin += by;
    } else {
        // These have directions alone; lights of shapes and media are made after the translation.
        static_assert(L::comes_from_afar || std::is_same_v<L, AreaLight> ||
                      std::is_same_v<L, MediumLight>);
    }
}

void move(Shapes& shapes, const Vec3d& by) {
    for (ShapeDescription& shape : shapes) move(shape.placed.to_world, by);
}

/// Translates the shapes of each object towards the origin of its frame, and its instances back.
void move_objects(SceneDescription& scene) {
    std::vector<Vec3d> origins;
    for (Shapes& object : scene.objects) {
        origins.push_back(origin_near(middle_of(boxes_of(object))));
        move(object, -origins.back());
    }
    for (InstanceDescription& instance : scene.instances) {
        const Vec3d place = Affine(instance.to_world).point(origins[instance.object]);
        for (int axis = 0; axis < 3; ++axis) instance.to_world[3][axis] = place[axis];
    }
}

std::shared_ptr<const Density> moved(const std::shared_ptr<const Density>& density,
                                     const Vec3d& by) {
    return density ? std::make_shared<const Density>(moved(*density, by)) : nullptr;
}

std::shared_ptr<const Glow> moved(const std::shared_ptr<const Glow>& glow, const Vec3d& by) {
    Glow there = *glow;
    there.factor = moved(there.factor, by);
    if (there.heat)
        there.heat =
            Heat{moved(there.heat->grid, by), there.heat->zero, there.heat->kelvin_per_unit};
    if (there.power) there.power = std::make_shared<const DensityGrid>(there.power->moved(by));
    return std::make_shared<const Glow>(std::move(there));
}

/// Alpha textures use world coordinates.
void move_covers(Shapes& shapes, const Vec3d& origin) {
    for (ShapeDescription& shape : shapes)
        if (shape.alpha) shape.placed.cover = cover_by(*shape.alpha, origin);
}

}  // namespace

Vec3d move_to_rendering_space(SceneDescription& scene) {
    move_objects(scene);
    const Vec3d origin = origin_near(middle_of(boxes_of_world(scene)));
    if (origin == Vec3d(0)) return origin;
    move(scene.shapes, -origin);
    for (InstanceDescription& instance : scene.instances) move(instance.to_world, -origin);
    for (Light& light : scene.lights) std::visit([&](auto& one) { move(one, -origin); }, light);
    for (Medium& medium : scene.media.all) {
        if (medium.density) medium.density = moved(medium.density, -origin);
        if (medium.glow) medium.glow = moved(medium.glow, -origin);
    }
    move_to(origin, scene.camera);
    move_covers(scene.shapes, origin);
    for (Shapes& object : scene.objects) move_covers(object, origin);
    return origin;
}

void move_to(const Vec3d& origin, Camera& camera) {
    std::visit([&](auto& one) { move(one.camera_to_world, -origin); }, camera);
}

}  // namespace sunfleck::engine
