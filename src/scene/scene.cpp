// Builds the scene: shapes to geometry, emitting shapes to lights, powers to a choice.
#include "scene/scene.h"

#include "geometry/measure.h"
#include "scene/area_lights.h"
#include "scene/media_check.h"
#include "scene/outer_medium.h"
#include "scene/rendering_space.h"
#include "scene/transmission.h"

#include <algorithm>

namespace sunfleck {
namespace {

/// Lights are weighed by what they emit in the visible range: power times luminance.
double weight_of(const Light& light, const SceneSphere& sphere) {
    return power(light, sphere) * std::max(0.0F, curve(light).luminance());
}

/// Can no path tell that a shape is there? Interfaces that neither emit nor part media are left
/// out, as are shapes that only emit.
bool is_left_out(const ShapeDescription& shape, const std::vector<Material>& materials) {
    const bool straight = std::holds_alternative<InterfaceMaterial>(materials[shape.material]);
    return shape.unseen || (straight && !shape.emission && !shape.media.parts());
}

/// By shape of the scene: its place in the file.
std::vector<SourceLocation> places_of_shapes(const SceneDescription& description,
                                             const std::vector<Material>& materials) {
    std::vector<SourceLocation> places;
    const auto add = [&](const std::vector<ShapeDescription>& shapes) {
        for (const ShapeDescription& shape : shapes)
            if (!is_left_out(shape, materials)) places.push_back(shape.where);
    };
    add(description.shapes);
    for (const auto& object : description.objects) add(object);
    return places;
}

}  // namespace

Scene::Scene(SceneDescription description, const std::string& isa)
    : origin_(move_to_rendering_space(description)),
      materials_(std::move(description.materials)),
      reliefs_(std::move(description.reliefs)),
      has_media_(description.media.absorb()),
      geometry_(take_shapes(description), isa),
      camera_(description.camera),
      filter_(description.filter),
      film_(std::move(description.film)),
      hints_(std::move(description.hints)),
      warnings_(std::move(description.warnings)),
      path_(std::move(description.path)) {
    const Bounds& bounds = geometry_.bounds();
    if (!bounds.is_empty()) sphere_ = {bounds.center(), std::max(bounds.radius(), 1e-6)};
    reliefs_.resize(materials_.size());
    finish_lights(description);
    if (!has_media_) return;
    join_media(std::move(description.media));
    mend_media(*this, places_of_shapes(description, materials_), shapes_, media_, warnings_);
    outer_medium_ = outer_medium_of(*this);
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (comes_from_afar(lights_[i])) media_.at_lights[i] = {outer_medium_, outer_medium_};
}

GeometryInput Scene::take_shapes(SceneDescription& description) {
    GeometryInput input;
    const auto take = [&](ShapeDescription& shape) -> std::optional<std::uint32_t> {
        if (!has_media_) shape.media = {};
        if (shape.unseen) {
            if (shape.emission) add_area_lights(shape, kNone);
            return {};
        }
        if (is_left_out(shape, materials_)) return {};
        if (std::holds_alternative<InterfaceMaterial>(materials_[shape.material]))
            has_straight_hits_ = true;
        const auto index = static_cast<std::uint32_t>(input.shapes.size());
        const bool has_cover = shape.placed.cover != nullptr;
        const bool parts_media = lets_light_through(materials_, shape.material);
        shapes_.push_back(
            {shape.material, kNone, parts_media ? shape.media : MediumSides{}, has_cover});
        if (shape.emission) add_area_lights(shape, index);
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
    return input;
}

void Scene::add_area_lights(const ShapeDescription& shape, std::uint32_t index) {
    if (index != kNone) shapes_[index].first_light = static_cast<std::uint32_t>(lights_.size());
    std::vector<AreaLight> made = area_lights_of(shape, index);
    light_sources_.push_back(
        {static_cast<std::uint32_t>(lights_.size()), static_cast<std::uint32_t>(made.size())});
    lights_.insert(lights_.end(), made.begin(), made.end());
    stated_in_.insert(stated_in_.end(), made.size(), shape.emission->statement);
    // Nothing parts the media where there is no surface: what is around the light is within, too.
    const MediumSides around{shape.media.outside, shape.media.outside};
    media_.at_lights.insert(media_.at_lights.end(), made.size(),
                            index == kNone ? around : shape.media);
}

void Scene::finish_lights(SceneDescription& description) {
    light_statements_ = std::move(description.light_statements);
    description.stated_in.resize(description.lights.size(), kNone);
    stated_in_.insert(stated_in_.end(), description.stated_in.begin(), description.stated_in.end());
    for (const Light& light : description.lights) {
        light_sources_.push_back({static_cast<std::uint32_t>(lights_.size()), 1});
        lights_.push_back(light);
    }
    std::vector<double> weights;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const bool infinite = is_infinite(lights_[i]);
        if (infinite) infinite_lights_.push_back(static_cast<std::uint32_t>(i));
        const auto* area = std::get_if<AreaLight>(&lights_[i]);
        if (infinite || (area != nullptr && !area->unseen)) has_lights_to_meet_ = true;
        weights.push_back(weight_of(lights_[i], sphere_));
    }
    light_choice_ = LightChoice(weights);
    light_tree_ = LightTree(lights_, weights);
    find_darkness(weights);
}

/// @param weights  of the lights.
void Scene::find_darkness(const std::vector<double>& weights) {
    const auto darken = [this](const std::string& why) {
        is_dark_ = true;
        warnings_.add({path_}, why + "; the picture will be black");
    };
    if (lights_.empty())
        darken("the scene has no light");
    else if (std::all_of(weights.begin(), weights.end(), [](double w) { return w <= 0; }))
        darken("no light of the scene has any power (L, I or scale is 0)");
    else if (geometry_.bounds().is_empty() && infinite_lights_.empty())
        darken("the scene has no shape and no infinite light: nothing can be seen");
}

/// @param media  as described; those at area lights are known already.
void Scene::join_media(Media media) {
    media.at_lights.resize(lights_.size() - media_.at_lights.size());
    media_.at_lights.insert(media_.at_lights.end(), media.at_lights.begin(), media.at_lights.end());
    media_.absorption = std::move(media.absorption);
    media_.at_camera = media.at_camera;
}

std::uint32_t Scene::light_of(const Hit& hit) const {
    const std::uint32_t first = shapes_[hit.shape].first_light;
    return first == kNone ? kNone : first + hit.primitive;
}

bool Scene::is_free(const Ray& ray) const {
    if (!has_straight_hits_) return !geometry_.occluded(ray);
    Ray rest = ray;
    while (const auto hit = geometry_.intersect(rest)) {
        if (!passes_straight(*hit)) return false;
        const float left = rest.length - hit->distance;
        rest = ray_from(*hit, ray.direction);
        rest.length = left;
        if (!(left > 0)) return true;
    }
    return true;
}

}  // namespace sunfleck
