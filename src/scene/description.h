// SceneDescription: a scene as importers deliver it, plain data with all defaults filled in.
#pragma once

#include "camera/camera.h"
#include "camera/filter.h"
#include "camera/pixel_window.h"
#include "core/warnings.h"
#include "geometry/geometry.h"
#include "light/light.h"
#include "light/surface_image.h"
#include "material/bump_map.h"
#include "material/material.h"
#include "scene/media.h"
#include "scene/names.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A statement of the scene file that makes one light or many.
struct LightStatement {
    std::string what;  // as in the file: LightSource "point"
    SourceLocation where;
};

/// Diffuse emission of a whole shape.
struct AreaEmission {
    Spectrum radiance;
    bool two_sided = false;
    /// If positive, each light of the shape (a quadric, each triangle or patch) emits radiance *
    /// power / (pi * area * (2 if two-sided)), where the spectrum itself is not normalised
    /// (pbrt-v4); an image is divided by its mean.
    double power = 0;
    /// Image that multiplies the radiance, by the surface's (u, v); null for none.
    std::shared_ptr<const SurfaceImage> image = nullptr;
    std::uint32_t statement = kNone;  // index into SceneDescription::light_statements
};

/// Returns alpha by a texture.
/// @param origin  of rendering space, in the world (scene/rendering_space.h).
inline Cover cover_by(FloatTexture alpha, const Vec3d& origin = Vec3d(0)) {
    return [alpha = std::move(alpha), origin](const Hit& hit) {
        return alpha.at(TexturePoint(hit, origin));
    };
}

struct ShapeDescription {
    PlacedShape placed;
    std::uint32_t material = 0;  // index into SceneDescription::materials
    std::optional<AreaEmission> emission;
    SourceLocation where;
    /// The alpha texture of placed.cover, if alpha is neither 0 nor 1.
    std::optional<FloatTexture> alpha = std::nullopt;
    bool unseen = false;  // it emits, but rays do not hit it (pbrt-v4's area lights of alpha 0)
    MediumSides media{};
    std::string name{};                        // as in the file (scene/names.h)
    std::shared_ptr<const PartNames> parts{};  // names of its parts, if it has several
};

struct InstanceDescription {
    std::uint32_t object = 0;  // index into SceneDescription::objects
    Matrix to_world;
    std::string name{};  // empty: those of its shapes
};

struct FilmDescription {
    Vec2i resolution{1280, 720};
    /// Rendered pixels [x0, x1) x [y0, y1) of the resolution; absent for all.
    std::optional<std::array<int, 4>> crop;
    float imaging_ratio = 1;  // pixel = radiance * exposure time * iso / 100
    /// White balance: temperature (kelvin) of the daylight that becomes white; absent for D65.
    std::optional<double> white;
    std::string filename;  // as in the scene; may be empty
};

/// Returns the rendered pixels of the film.
inline PixelWindow window_of(const FilmDescription& film) {
    if (!film.crop) return {0, 0, film.resolution.x, film.resolution.y};
    const auto& c = *film.crop;
    return {c[0], c[2], c[1], c[3]};
}

/// What the scene asks of the renderer; flags of the command line take precedence.
struct RenderHints {
    std::string integrator;  // as in the scene
    std::optional<int> max_depth;
};

/// A word of the scene file's language, such as "Shape" "sphere".
struct UsedWord {
    std::string directive;
    std::string word;
    std::size_t count = 0;
};

struct SceneDescription {
    Camera camera;
    FilterSettings filter;
    FilmDescription film;
    RenderHints hints;
    std::vector<Material> materials;
    std::vector<BumpMap> bump_maps;           // per material; those beyond the end are empty
    std::vector<std::string> material_names;  // likewise
    std::vector<ShapeDescription> shapes;     // in the world
    std::vector<std::vector<ShapeDescription>> objects;  // each list once, placed by instances
    std::vector<InstanceDescription> instances;
    std::vector<LightStatement> light_statements;  // in file order
    std::vector<Light> lights;                     // all lights except area lights
    std::vector<std::uint32_t> stated_in;          // light_statements by `lights`; may be shorter
    Media media;                                   // at_lights: of `lights`
    /// Illuminance lights (pbrt's "illuminance" of infinite lights) and "power" of spots and points
    /// are already in the spectra.
    Warnings warnings;
    std::string path;                 // of the main file
    std::vector<std::string> files;   // all that were read, each once
    std::optional<std::string> text;  // of the main file, if it came from standard input
    std::vector<UsedWord> words;      // sorted
};

}  // namespace sunfleck::engine
