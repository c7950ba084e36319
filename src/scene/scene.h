// Scene: the immutable whole of surfaces, materials, lights and camera, ready for rendering.
//
// In:  a SceneDescription. Out: hits with their material and emission. Thread-safe.
// Copies share geometry and lights, and may have a camera and a film of their own.
#pragma once

#include "scene/description.h"
#include "scene/media_check.h"
#include "scene/medium_around.h"
#include "scene/scene_lights.h"
#include "scene/surfaces.h"

#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

class Scene {
public:
    /// @param isa  see Geometry. @throws Error  for a scene that cannot be built.
    explicit Scene(SceneDescription description, const std::string& isa = "avx2");

    /// Sets another camera and film; the scene is then as if it had been built with them.
    /// @param camera  in world space.
    void set_view(Camera camera, FilmDescription film);
    /// Enables energy compensation, as compensate_energy() of scene/adjust.h.
    void compensate_energy() { surfaces_.compensate_energy(); }

    /// Returns the origin of rendering space in the world (scene/rendering_space.h). All positions
    /// of the scene (surfaces, lights, camera) are relative to it.
    const Vec3d& origin() const { return origin_; }
    const Geometry& geometry() const { return surfaces_.geometry(); }
    const Camera& camera() const { return camera_; }
    const FilterSettings& filter() const { return filter_; }
    const FilmDescription& film() const { return film_; }
    const RenderHints& hints() const { return hints_; }

    // See SceneLights.
    const std::vector<Light>& lights() const { return lights_->all(); }
    const std::vector<std::uint32_t>& infinite_lights() const { return lights_->infinite(); }
    const LightChoice& light_choice() const { return lights_->choice(); }
    const std::vector<LightRange>& light_sources() const { return lights_->sources(); }
    const std::vector<LightStatement>& light_statements() const { return lights_->statements(); }
    const std::vector<std::uint32_t>& stated_in() const { return lights_->stated_in(); }
    const LightTree& light_tree() const { return lights_->tree(); }
    const SceneSphere& sphere() const { return lights_->sphere(); }
    bool has_lights_to_hit() const { return lights_->has_lights_to_hit(); }

    const Warnings& warnings() const { return warnings_; }
    const std::string& path() const { return path_; }
    /// Returns whether every picture is black: no light has power, or nothing can be seen.
    bool is_dark() const { return is_dark_; }

    // See Surfaces.
    const std::vector<Material>& materials() const { return surfaces_.materials(); }
    std::uint32_t material_of(const Hit& hit) const { return surfaces_.material_of(hit); }
    std::uint32_t light_of(const Hit& hit) const { return surfaces_.light_of(hit); }
    bool is_null_interface(const Hit& hit) const { return surfaces_.is_null_interface(hit); }
    bool has_cover(const Hit& hit) const { return surfaces_.has_cover(hit); }
    bool is_free(const Ray& ray) const { return surfaces_.is_free(ray); }

    const SceneNames& names() const { return *names_; }
    /// Returns the bump or normal map of a material.
    const BumpMap& bump_map_of(std::uint32_t material) const { return bump_maps_[material]; }
    /// Returns the first hit of a camera ray, traced in double where floats are too coarse.
    std::optional<Hit> first_hit(const CameraRay& ray) const {
        if (ray.needs_double()) return geometry().intersect_precise(ray.origin, ray.direction);
        return geometry().intersect({Vec3(ray.origin), Vec3(ray.direction)});
    }

    /// Returns whether any medium does anything; if none does, media are ignored.
    bool has_media() const { return has_media_; }
    /// Returns the media; at_lights has one entry per light. Distant and infinite lights are in
    /// outer_medium().
    const Media& media() const { return media_; }
    /// Returns the medium around the scene.
    MediumNumber outer_medium() const { return outer_medium_; }
    /// Returns the medium around a point.
    MediumNumber medium_around(const Vec3& point) const {
        return sunfleck::engine::medium_around(surfaces_, point, last_medium_);
    }
    bool separates_media(const Hit& hit) const { return surfaces_.separates_media(hit); }
    /// Returns the medium of a path that leaves a hit into `direction`. @param before  medium of
    /// the path before.
    MediumNumber medium_beyond(const Hit& hit, const Vec3& direction, MediumNumber before) const {
        return has_media_ ? surfaces_.medium_beyond(hit, direction, before) : before;
    }

private:
    Surfaces take_shapes(SceneDescription& description, const std::string& isa);
    void add_area_lights(const ShapeDescription& shape, std::uint32_t index);
    void finish_lights(const SceneDescription& description);
    void find_darkness();
    void join_media(Media media);
    void place_view();

    Vec3d origin_;
    bool has_media_ = false;
    Media media_;
    MediumNumber outer_medium_ = 0;
    MediumNumber last_medium_ = 0;  // behind all surfaces, be they opaque
    std::vector<BumpMap> bump_maps_;
    std::shared_ptr<SceneLights> lights_;
    std::shared_ptr<const SceneNames> names_;
    Surfaces surfaces_;
    bool is_dark_ = false;
    Camera camera_;
    FilterSettings filter_;
    FilmDescription film_;
    RenderHints hints_;
    Warnings warnings_;
    std::string path_;

    /// Media and warnings of the scene description, from which each view starts.
    struct BeforeViews {
        Media media;
        Warnings warnings;
        ScenePlaces places;
    };
    std::shared_ptr<const BeforeViews> before_views_;
    /// Shapes whose inside and outside media are exchanged for the present view.
    std::vector<std::uint32_t> exchanged_;
};

}  // namespace sunfleck::engine
