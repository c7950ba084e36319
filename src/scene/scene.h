// The immutable whole: surfaces, materials, lights and camera, ready to be traced.
//
// In:  a SceneDescription. Out: hits with their material and emission. Any number of threads.
#pragma once

#include "scene/description.h"
#include "scene/scene_lights.h"
#include "scene/surfaces.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

class Scene {
public:
    /// @param isa  see Geometry. @throws Error for a scene that cannot be built.
    explicit Scene(SceneDescription description, const std::string& isa = "avx2");

    /// Where the origin of rendering space is in the world (scene/rendering_space.h). All places
    /// that the scene gives or takes (of surfaces, lights, the camera) are relative to it.
    const Vec3d& origin() const { return origin_; }
    const Geometry& geometry() const { return surfaces_.geometry(); }
    const Camera& camera() const { return camera_; }
    const FilterSettings& filter() const { return filter_; }
    const FilmDescription& film() const { return film_; }
    const RenderHints& hints() const { return hints_; }

    // As SceneLights says.
    const std::vector<Light>& lights() const { return lights_.all(); }
    const std::vector<std::uint32_t>& infinite_lights() const { return lights_.infinite(); }
    const LightChoice& light_choice() const { return lights_.choice(); }
    const std::vector<LightRange>& light_sources() const { return lights_.sources(); }
    const std::vector<LightStatement>& light_statements() const { return lights_.statements(); }
    const std::vector<std::uint32_t>& stated_in() const { return lights_.stated_in(); }
    const LightTree& light_tree() const { return lights_.tree(); }
    const SceneSphere& sphere() const { return lights_.sphere(); }
    bool has_lights_to_meet() const { return lights_.has_lights_to_meet(); }

    const Warnings& warnings() const { return warnings_; }
    const std::string& path() const { return path_; }
    /// Is every picture of it black? No light has any power, or there is nothing to see.
    bool is_dark() const { return is_dark_; }

    // As Surfaces says.
    const std::vector<Material>& materials() const { return surfaces_.materials(); }
    std::uint32_t material_of(const Hit& hit) const { return surfaces_.material_of(hit); }
    std::uint32_t light_of(const Hit& hit) const { return surfaces_.light_of(hit); }
    bool is_null_interface(const Hit& hit) const { return surfaces_.is_null_interface(hit); }
    bool has_cover(const Hit& hit) const { return surfaces_.has_cover(hit); }
    bool is_free(const Ray& ray) const { return surfaces_.is_free(ray); }

    /// Of the material's surfaces.
    const Relief& relief_of(std::uint32_t material) const { return reliefs_[material]; }
    /// What a camera ray meets first; looked for in double where floats are too coarse for it.
    std::optional<Hit> first_hit(const CameraRay& ray) const {
        if (ray.needs_double()) return geometry().intersect_precise(ray.origin, ray.direction);
        return geometry().intersect({Vec3(ray.origin), Vec3(ray.direction)});
    }

    /// Is there a medium that absorbs? If not, there are none.
    bool has_media() const { return has_media_; }
    /// at_lights: of lights(), each has its own; distant and infinite ones stand in outer_medium().
    const Media& media() const { return media_; }
    /// What surrounds everything.
    MediumNumber outer_medium() const { return outer_medium_; }
    bool parts_media(const Hit& hit) const { return surfaces_.parts_media(hit); }
    /// Where a path is that leaves a hit into `direction`. @param before  where it came from.
    MediumNumber medium_beyond(const Hit& hit, const Vec3& direction, MediumNumber before) const {
        return has_media_ ? surfaces_.medium_beyond(hit, direction, before) : before;
    }

private:
    Surfaces take_shapes(SceneDescription& description, const std::string& isa);
    void add_area_lights(const ShapeDescription& shape, std::uint32_t index);
    void finish_lights(const SceneDescription& description);
    void find_darkness();
    void join_media(Media media);

    Vec3d origin_;
    bool has_media_ = false;
    Media media_;
    MediumNumber outer_medium_ = 0;
    std::vector<Relief> reliefs_;
    SceneLights lights_;
    Surfaces surfaces_;
    bool is_dark_ = false;
    Camera camera_;
    FilterSettings filter_;
    FilmDescription film_;
    RenderHints hints_;
    Warnings warnings_;
    std::string path_;
};

}  // namespace sunfleck::engine
