// The immutable whole: surfaces, materials, lights and camera, ready to be traced.
//
// In:  a SceneDescription. Out: hits with their material and emission. Any number of threads.
#pragma once

#include "light/light_clusters.h"
#include "light/light_tree.h"
#include "scene/description.h"

#include <string>
#include <vector>

namespace sunfleck {

/// What the scene knows of one shape beyond its geometry.
struct ShapeRecord {
    std::uint32_t material = 0;
    std::uint32_t first_light = kNone;  // light of primitive 0, if it emits; the others follow
    MediumSides media{};
    bool has_cover = false;  // it is there in part: rays pass it by chance
};

class Scene {
public:
    /// @param isa  see Geometry. @throws Error for a scene that cannot be built.
    explicit Scene(SceneDescription description, const std::string& isa = "avx2");

    /// Where the origin of rendering space is in the world (scene/rendering_space.h). All places
    /// that the scene gives or takes (of surfaces, lights, the camera) are relative to it.
    const Vec3d& origin() const { return origin_; }
    const Geometry& geometry() const { return geometry_; }
    const Camera& camera() const { return camera_; }
    const FilterSettings& filter() const { return filter_; }
    const FilmDescription& film() const { return film_; }
    const RenderHints& hints() const { return hints_; }
    const std::vector<Material>& materials() const { return materials_; }
    const std::vector<Light>& lights() const { return lights_; }
    const std::vector<std::uint32_t>& infinite_lights() const { return infinite_lights_; }
    /// By power: photons start at lights chosen by it.
    const LightChoice& light_choice() const { return light_choice_; }
    /// Lights that belong together: those of one shape, or one by itself; in the order of lights().
    const std::vector<LightRange>& light_sources() const { return light_sources_; }
    /// What the file says of lights, in its order.
    const std::vector<LightStatement>& light_statements() const { return light_statements_; }
    /// By light, the one of these that it comes from, or kNone.
    const std::vector<std::uint32_t>& stated_in() const { return stated_in_; }
    /// By what arrives at a point: direct light is sampled at lights chosen by it.
    const LightTree& light_tree() const { return light_tree_; }
    const SceneSphere& sphere() const { return sphere_; }
    const Warnings& warnings() const { return warnings_; }
    const std::string& path() const { return path_; }
    /// Is every picture of it black? No light has any power, or there is nothing to see.
    bool is_dark() const { return is_dark_; }
    /// Are there lights that a ray can meet (area, infinite)?
    bool has_lights_to_meet() const { return has_lights_to_meet_; }

    /// Of the material's surfaces.
    const Relief& relief_of(std::uint32_t material) const { return reliefs_[material]; }
    std::uint32_t material_of(const Hit& hit) const { return shapes_[hit.shape].material; }
    /// The area light at a hit, or kNone.
    std::uint32_t light_of(const Hit& hit) const;
    /// Is the surface no obstacle: light goes straight on, and it is no bounce? Shadow rays, eye
    /// and photon paths all ask here. (Interfaces that do not emit are not in the geometry.)
    bool passes_straight(const Hit& hit) const {
        return std::holds_alternative<InterfaceMaterial>(materials_[material_of(hit)]);
    }

    /// Is the surface there in part? If so, Geometry::is_there() says whether it stops a ray.
    bool has_cover(const Hit& hit) const { return shapes_[hit.shape].has_cover; }

    /// What a camera ray meets first; looked for in double where floats are too coarse for it.
    std::optional<Hit> first_hit(const CameraRay& ray) const {
        if (ray.needs_double()) return geometry_.intersect_precise(ray.origin, ray.direction);
        return geometry_.intersect({Vec3(ray.origin), Vec3(ray.direction)});
    }

    /// Is the way from `from` to the end of the ray free, surfaces passed straight aside?
    bool is_free(const Ray& ray) const;

    /// Is there a medium that absorbs? If not, there are none.
    bool has_media() const { return has_media_; }
    /// at_lights: of lights(), each has its own; distant and infinite ones stand in outer_medium().
    const Media& media() const { return media_; }
    /// What surrounds everything.
    MediumNumber outer_medium() const { return outer_medium_; }
    bool parts_media(const Hit& hit) const { return shapes_[hit.shape].media.parts(); }
    /// Where a path is that leaves a hit into `direction`. @param before  where it came from.
    MediumNumber medium_beyond(const Hit& hit, const Vec3& direction, MediumNumber before) const {
        if (!has_media_) return before;
        const MediumSides& sides = shapes_[hit.shape].media;
        return sides.parts() ? sides.towards(hit.normal, direction) : before;
    }

private:
    GeometryInput take_shapes(SceneDescription& description);
    void add_area_lights(const ShapeDescription& shape, std::uint32_t index);
    void finish_lights(SceneDescription& description);
    void find_darkness(const std::vector<double>& weights);
    void join_media(Media media);

    Vec3d origin_;
    std::vector<Material> materials_;
    std::vector<Relief> reliefs_;
    std::vector<ShapeRecord> shapes_;
    std::vector<Light> lights_;
    std::vector<LightRange> light_sources_;
    std::vector<LightStatement> light_statements_;
    std::vector<std::uint32_t> stated_in_;
    std::vector<std::uint32_t> infinite_lights_;
    bool is_dark_ = false;
    bool has_lights_to_meet_ = false;
    bool has_straight_hits_ = false;
    bool has_media_ = false;
    MediumNumber outer_medium_ = 0;
    Media media_;
    Geometry geometry_;
    SceneSphere sphere_;
    LightChoice light_choice_;
    LightTree light_tree_;
    Camera camera_;
    FilterSettings filter_;
    FilmDescription film_;
    RenderHints hints_;
    Warnings warnings_;
    std::string path_;
};

/// The next ray along `direction` from a hit, past its surface.
inline Ray ray_from(const Hit& hit, const Vec3& direction) {
    return {offset_origin(hit.position, hit.normal, hit.error, direction), direction};
}

/// The segment from a hit towards a point `distance` away, short of whatever stands there.
inline Ray shadow_ray(const Hit& hit, const Vec3& direction, float distance) {
    Ray ray = ray_from(hit, direction);
    ray.length = distance * (1 - 1e-4F);
    return ray;
}

}  // namespace sunfleck
