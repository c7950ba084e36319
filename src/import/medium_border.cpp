// A null interface between the medium and empty space.
#include "import/medium_border.h"

#include "scene/additions.h"
#include "scene/camera_view.h"
#include "scene/framing.h"
#include "scene/scene.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// As far as pbrt-v4's light samples reach, from the middle of a scene.
constexpr double kOuterOverRadius = 2;

bool has_no_end(const Medium& medium) {
    return acts(medium) && !medium.density;
}

/// Returns whether it is worth a look where the scene ends: a path may leave the scene in a medium
/// without end, at the camera or beyond some surface.
bool may_have_no_end(const SceneDescription& scene) {
    const auto endless = [&](MediumNumber medium) { return has_no_end(scene.media.all[medium]); };
    const auto is_before_endless = [&](const ShapeDescription& shape) {
        return shape.media.differ() && endless(shape.media.outside);
    };
    return endless(scene.media.at_camera) ||
           std::any_of(scene.shapes.begin(), scene.shapes.end(), is_before_endless);
}

}  // namespace

void end_at_sphere(SceneDescription& scene, MediumNumber medium, double size) {
    Bounds all = bounds_of_scene(scene);
    all.extend(CameraView{scene.camera, scene.film.resolution}.middle_ray().origin);
    const double radius = std::max(size * all.radius(), 1e-6);
    Matrix to_world;
    to_world.setTranslation(all.center());
    ShapeDescription border;
    border.placed = {Sphere{radius, -radius, radius}, to_world};
    border.material = add_material(scene, InterfaceMaterial{});
    border.media = {medium, 0};
    scene.shapes.push_back(std::move(border));
}

void end_outer_medium(SceneDescription& scene) {
    const auto& all = scene.media.all;
    if (std::none_of(scene.lights.begin(), scene.lights.end(), comes_from_afar) &&
        std::none_of(all.begin(), all.end(), [](const Medium& m) { return emits(m); }))
        return;
    if (!may_have_no_end(scene)) return;
    const MediumNumber outer = Scene(scene).outer_medium();
    if (!has_no_end(scene.media.all[outer])) return;
    scene.warnings.add({scene.path},
                       "the medium around the scene has no end, so that no light from afar would "
                       "come through it, and its own from everywhere: it ends at a sphere of twice "
                       "the scene's radius");
    end_at_sphere(scene, outer, kOuterOverRadius);
}

}  // namespace sunfleck::engine
