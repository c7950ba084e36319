// Construction of the scene: shapes become surfaces, emitting shapes become lights.
#include "scene/scene.h"

#include "geometry/extent.h"
#include "scene/area_lights.h"
#include "scene/media_check.h"
#include "scene/medium_lights.h"
#include "scene/outer_medium.h"
#include "scene/rendering_space.h"
#include "scene/transmission.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Warns of a shape that ray tracing leaves out, whole or in part, since it is too large or too
/// far.
void warn_of_extent(const ShapeDescription& shape, Warnings& warnings) {
    const std::size_t left_out = count_out_of_range(shape.placed);
    if (left_out == 0) return;
    const std::string surfaces = left_out == 1 ? " surface is" : " surfaces are";
    warnings.add(shape.where,
                 "coordinates of about 10^17 and more are too large for ray tracing: " +
                     std::to_string(left_out) + surfaces +
                     " left out of this shape (triangles, if it is a mesh), and dark");
}

/// Returns whether a shape has no effect on paths: interfaces that neither emit nor separate media,
/// and shapes that only emit.
bool is_left_out(const ShapeDescription& shape, const std::vector<Material>& materials) {
    const bool straight = std::holds_alternative<InterfaceMaterial>(materials[shape.material]);
    return shape.unseen || (straight && !shape.emission && !shape.media.differ());
}

/// Returns names, each in place of an empty one. @param what  "material": the names given are
/// "material 1" and so on.
std::vector<std::string> named(std::vector<std::string> names, const std::string& what) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i].empty()) names[i] = what + ' ' + std::to_string(i + 1);
    return names;
}

/// @param shapes  names of the shapes that are in the geometry, and of their parts.
std::shared_ptr<const SceneNames> names_of(SceneDescription& description, SceneNames shapes) {
    SceneNames names{.materials = std::move(description.material_names),
                     .shapes = named(std::move(shapes.shapes), "shape"),
                     .parts = std::move(shapes.parts),
                     .instances = {}};
    names.materials.resize(description.materials.size());
    names.materials = named(std::move(names.materials), "material");
    names.instances.reserve(description.instances.size());
    for (InstanceDescription& instance : description.instances)
        names.instances.push_back(std::move(instance.name));
    return std::make_shared<const SceneNames>(std::move(names));
}

ScenePlaces places_of(const SceneDescription& description, const std::string& path,
                      const std::vector<Material>& materials) {
    ScenePlaces places{path, {}};
    const auto add = [&](const std::vector<ShapeDescription>& shapes) {
        for (const ShapeDescription& shape : shapes)
            if (!is_left_out(shape, materials)) places.shapes.push_back(shape.where);
    };
    add(description.shapes);
    for (const auto& object : description.objects) add(object);
    return places;
}

}  // namespace

Scene::Scene(SceneDescription description, const std::string& isa)
    : origin_(move_to_rendering_space(description)),
      has_media_(description.media.act()),
      bump_maps_(std::move(description.bump_maps)),
      lights_(std::make_shared<SceneLights>(std::move(description.light_statements))),
      surfaces_(take_shapes(description, isa)),
      filter_(description.filter),
      hints_(std::move(description.hints)),
      warnings_(std::move(description.warnings)),
      path_(std::move(description.path)) {
    bump_maps_.resize(materials().size());
    finish_lights(description);
    if (has_media_) join_media(std::move(description.media));
    find_darkness();
    before_views_ = std::make_shared<const BeforeViews>(
        BeforeViews{media_, warnings_, places_of(description, path_, materials())});
    camera_ = description.camera;
    film_ = std::move(description.film);
    if (has_media_) place_view();
}

void Scene::set_view(Camera camera, FilmDescription film) {
    camera_ = std::move(camera);
    move_to(origin_, camera_);
    film_ = std::move(film);
    warnings_ = before_views_->warnings;
    if (!has_media_) return;
    media_ = before_views_->media;
    for (const std::uint32_t shape : exchanged_) surfaces_.exchange_media(shape);
    place_view();
}

/// Finds the medium around the camera and around everything.
void Scene::place_view() {
    const CameraView view{camera_, film_.resolution};
    exchanged_ = mend_media(surfaces_, media_, {view, *lights_}, before_views_->places, warnings_);
    outer_medium_ = outer_medium_of(surfaces_, view, media_.at_camera);
    last_medium_ = medium_behind_all(surfaces_, Vec3(view.middle_ray().origin), media_.at_camera);
    for (std::size_t i = 0; i < lights().size(); ++i)
        if (comes_from_afar(lights()[i])) media_.at_lights[i] = {outer_medium_, outer_medium_};
}

Surfaces Scene::take_shapes(SceneDescription& description, const std::string& isa) {
    if (has_media_) add_medium_lights(description);
    const std::vector<Material>& materials = description.materials;
    GeometryInput input;
    std::vector<ShapeRecord> records;
    SceneNames names;
    const auto take = [&](ShapeDescription& shape) -> std::optional<std::uint32_t> {
        if (!has_media_) shape.media = {};
        warn_of_extent(shape, description.warnings);
        if (shape.unseen) {
            if (shape.emission) add_area_lights(shape, kNone);
            return {};
        }
        if (is_left_out(shape, materials)) return {};
        const auto index = static_cast<std::uint32_t>(input.shapes.size());
        const bool separates_media = lets_light_through(materials, shape.material);
        ShapeRecord& record = records.emplace_back();
        record.material = shape.material;
        if (shape.emission) record.first_light = static_cast<std::uint32_t>(lights().size());
        if (separates_media) record.media = shape.media;
        record.has_cover = shape.placed.cover != nullptr;
        if (shape.emission) add_area_lights(shape, index);
        names.shapes.push_back(std::move(shape.name));
        names.parts.push_back(std::move(shape.parts));
        input.shapes.push_back(std::move(shape.placed));
        return index;
    };
    for (ShapeDescription& shape : description.shapes)
        if (const auto index = take(shape)) input.in_world.push_back(*index);
    std::vector<std::vector<std::uint32_t>> objects;
    for (auto& object : description.objects) {
        objects.emplace_back();
        for (ShapeDescription& shape : object)
            if (const auto index = take(shape)) objects.back().push_back(*index);
    }
    for (const InstanceDescription& instance : description.instances)
        input.instances.push_back({objects[instance.object], instance.to_world, instance.object});
    names_ = names_of(description, std::move(names));
    return {std::move(input), isa, std::move(records), std::move(description.materials)};
}

void Scene::add_area_lights(const ShapeDescription& shape, std::uint32_t index) {
    const std::vector<AreaLight> made = area_lights_of(shape, index);
    lights_->add(made, shape.emission->statement);
    // Without a surface the medium around the light is the one within, too.
    const MediumSides around{shape.media.outside, shape.media.outside};
    media_.at_lights.insert(media_.at_lights.end(), made.size(),
                            index == kNone ? around : shape.media);
}

/// Adds the lights that are not area lights, which have been added before.
void Scene::finish_lights(const SceneDescription& description) {
    for (std::size_t i = 0; i < description.lights.size(); ++i)
        lights_->add(description.lights[i],
                     i < description.stated_in.size() ? description.stated_in[i] : kNone);
    const Bounds& bounds = geometry().bounds();
    SceneSphere sphere;
    if (!bounds.is_empty()) sphere = {bounds.center(), std::max(bounds.radius(), 1e-6)};
    lights_->finish(sphere);
}

void Scene::find_darkness() {
    const auto darken = [this](const std::string& why) {
        is_dark_ = true;
        warnings_.add({path_}, why + "; the picture will be black");
    };
    if (lights().empty())
        darken("the scene has no light");
    else if (!lights_->has_power())
        darken("no light of the scene has any power (L, I or scale is 0)");
    else if (geometry().bounds().is_empty() && infinite_lights().empty() &&
             std::none_of(media_.all.begin(), media_.all.end(),
                          [](const Medium& m) { return scatters(m) || emits(m); }))
        darken("the scene has no shape and no infinite light: nothing can be seen");
}

/// @param media  as described; those at area lights are set already.
void Scene::join_media(Media media) {
    media.at_lights.resize(lights().size() - media_.at_lights.size());
    media_.at_lights.insert(media_.at_lights.end(), media.at_lights.begin(), media.at_lights.end());
    media_.all = std::move(media.all);
    media_.at_camera = media.at_camera;
}

}  // namespace sunfleck::engine
