// A scene as importers hand it over: plain data, every default already filled in.
#pragma once

#include "camera/camera.h"
#include "camera/filter.h"
#include "camera/pixel_window.h"
#include "core/warnings.h"
#include "geometry/geometry.h"
#include "light/light.h"
#include "light/surface_picture.h"
#include "material/bump_map.h"
#include "material/material.h"
#include "scene/media.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Light as the scene's file states it: one statement may make many lights.
struct LightStatement {
    std::string what;  // as the file has it: LightSource "point"
    SourceLocation where;
};

/// Diffuse emission of a whole shape.
struct AreaEmission {
    Spectrum radiance;
    bool two_sided = false;
    /// When positive: each light of the shape (a quadric, each triangle or patch) emits radiance *
    /// power / (pi * area * (2 if two-sided)), the curve itself not normalised (pbrt-v4); a picture
    /// is divided by its mean.
    double power = 0;
    /// What the radiance is multiplied by, by the (u, v) of the surface; null: one.
    std::shared_ptr<const SurfacePicture> picture = nullptr;
    std::uint32_t statement = kNone;  // index into SceneDescription::light_statements
};

/// The part of a surface that is there, as a texture says.
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
    /// "alpha", where it is neither 0 nor 1: that of placed.cover.
    std::optional<FloatTexture> alpha = std::nullopt;
    bool unseen = false;  // it emits, and else it is not there (pbrt-v4's lights of alpha 0)
    MediumSides media{};
};

struct InstanceDescription {
    std::uint32_t object = 0;  // index into SceneDescription::objects
    Matrix to_world;
};

struct FilmDescription {
    Vec2i resolution{1280, 720};
    /// Pixels [x0, x1) x [y0, y1) of the resolution that are rendered; all when absent.
    std::optional<std::array<int, 4>> crop;
    float imaging_ratio = 1;  // pixel = radiance * exposure time * iso / 100
    /// White balance: the temperature of daylight (kelvin) that is to be white; absent: D65 is.
    std::optional<double> white;
    std::string filename;  // as the scene names it; empty when it does not
};

/// The pixels that the film renders.
inline PixelWindow window_of(const FilmDescription& film) {
    if (!film.crop) return {0, 0, film.resolution.x, film.resolution.y};
    const auto& c = *film.crop;
    return {c[0], c[2], c[1], c[3]};
}

/// What the scene asks of the renderer; the command line wins.
struct RenderHints {
    std::string integrator;  // the scene's word
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
    std::vector<Relief> reliefs;                         // by material; flat where there are fewer
    std::vector<ShapeDescription> shapes;                // in the world
    std::vector<std::vector<ShapeDescription>> objects;  // each list once, placed by instances
    std::vector<InstanceDescription> instances;
    std::vector<LightStatement> light_statements;  // in the order of the file
    std::vector<Light> lights;                     // all but area lights
    std::vector<std::uint32_t> stated_in;  // of `lights`: light_statements; by none where there
                                           // are fewer
    Media media;                           // at_lights: of `lights`
    /// Illuminance lights (pbrt "illuminance" on infinite lights) and spot/point "power" are
    /// already in the curves.
    Warnings warnings;
    std::string path;                 // of the main file
    std::vector<std::string> files;   // all that were read, each once
    std::optional<std::string> text;  // of the main file, if it is no file but standard input
    std::vector<UsedWord> words;      // sorted
};

}  // namespace sunfleck::engine
