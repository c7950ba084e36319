// Ground and camera of a part.
#include "import/part/surroundings.h"

#include "import/part/look.h"
#include "scene/framing.h"

#include <variant>

namespace sunfleck::engine {
namespace {

/// A frame for what stands: right, front, up in the world.
struct Standing {
    Vec3d right{1, 0, 0};
    Vec3d front;
    Vec3d up;
};

Standing standing(UpAxis up) {
    if (up == UpAxis::z) return {.front = {0, -1, 0}, .up = {0, 0, 1}};
    return {.front = {0, 0, 1}, .up = {0, 1, 0}};
}

}  // namespace

void add_ground(SceneDescription& scene, const Bounds& part, UpAxis up) {
    // The picture's upper edge looks down by 11 degrees: it sees the ground within 12 radii.
    constexpr double kRadii = 30;
    constexpr double kGap = 1e-4;  // radii
    constexpr float kReflectance = 0.5F;
    const Standing frame = standing(up);
    const double radius = part.radius();
    const double lowest = part.min.dot(frame.up);
    const Vec3d centre = part.center();
    const Vec3d below = centre + frame.up * (lowest - kGap * radius - centre.dot(frame.up));
    ShapeDescription ground;
    TriangleMesh mesh;
    const float half = 1;
    for (const Vec2& corner :
         {Vec2(-half, half), Vec2(half, half), Vec2(half, -half), Vec2(-half, -half)}) {
        const Vec3d place = frame.right * static_cast<double>(corner.x) +
                            frame.front * static_cast<double>(corner.y);
        mesh.positions.emplace_back(place);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    ground.placed.shape = std::move(mesh);
    for (int c = 0; c < 3; ++c) {
        ground.placed.to_world[c][c] = kRadii * radius;
        ground.placed.to_world[3][c] = below[c];
    }
    ground.material = add_material(scene, DiffuseMaterial{Spectrum::constant(kReflectance)});
    ground.where = {scene.path};
    ground.name = "ground";
    name_material(scene, ground.material, "ground");
    scene.shapes.push_back(std::move(ground));
}

void set_part_view(SceneDescription& scene, UpAxis up) {
    const Standing frame = standing(up);
    Framing framing;
    framing.towards_camera = frame.front + frame.right * 0.55 + frame.up * 0.55;
    framing.up = frame.up;
    framing.yfov = 30 * kPiDouble / 180;
    framing.fill = 0.7;
    const Bounds bounds = bounds_of_scene(scene);
    FramedView view(framing, kUsualResolution, bounds.center());
    for (const ShapeDescription& shape : scene.shapes) {
        const Affine to_world(shape.placed.to_world);
        for (const Vec3& p : std::get<TriangleMesh>(shape.placed.shape).positions)
            view.add(to_world.point(Vec3d(p)));
    }
    scene.film.resolution = kUsualResolution;
    scene.camera = view.camera(bounds.radius());
}

}  // namespace sunfleck::engine
