// RenderRequest: what a user asks of a render, independent of the scene.
//
// Files, threads and messages belong to the program and are not here.
#pragma once

#include "camera/camera.h"
#include "flags/light_groups.h"
#include "image/exposure.h"
#include "image/picture_file.h"
#include "stages/settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct FilmDescription;
struct SceneDescription;

struct RenderRequest {
    RenderSettings settings;
    StopSettings stop;
    bool ends_by_default = false;  // no end was given: `stop` holds the default ends
    std::optional<int> max_depth;  // in place of the scene's
    std::optional<Vec2i> resolution;
    std::optional<std::array<int, 4>> crop;            // x0 x1 y0 y1 in pixels
    std::optional<std::array<double, 4>> crop_window;  // the same as fractions of the picture
    std::vector<AskedLightGroup> light_groups;
    std::string isa = "avx2";
    /// For formats of limited range alone. Absent: automatic for scenes in physical units, which
    /// are all but pbrt's, and 0 for pbrt's.
    std::optional<Exposure> exposure;
    PictureFileOptions files{};  // how pictures are written; the exposure is the one above
};

/// Changes the view of a scene as the request says: size and crop.
/// @throws Error for a crop that is not a part of the picture.
void adjust_view(Camera& camera, FilmDescription& film, const RenderRequest& request);

/// Changes a scene that is not built yet as the request says: size, crop, energy compensation.
/// @throws Error for a crop that is not a part of the picture.
void adjust_scene(SceneDescription& scene, const RenderRequest& request);

/// Returns the settings of the request for this scene: with the scene's maximum depth if none is
/// given, and with the lights of each light group. @throws Error for lights that the scene does not
/// have.
RenderSettings settings_for(const Scene& scene, const RenderRequest& request);

}  // namespace sunfleck::engine
