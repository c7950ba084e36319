// SceneRequest: what a user says about a scene besides its file.
#pragma once

#include "import/fog.h"
#include "scene/import_settings.h"
#include "sky/daylight.h"
#include "sky/environment.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Kinds of scene files, by what they leave open.
enum class SceneFormat {
    pbrt,  // nothing
    gltf,  // light, and details
    part   // OBJ, STL, PLY: all but the shape
};

/// A flag of the scene, as given.
struct GivenFlag {
    std::string name;
    std::string text;
    std::vector<SceneFormat> formats;  // for which it has a meaning
};

/// A light that gets the intensities of a luminaire.
struct AskedLuminaire {
    std::string light;  // number from 1, or name
    std::string file;   // IES
};

struct SceneRequest {
    ImportSettings import;
    Daylight daylight;          // used if asked for, or where a file has no light
    bool has_daylight = false;  // asked for
    std::optional<EnvironmentPicture> environment;
    std::vector<AskedLuminaire> luminaires{};
    std::optional<Fog> fog;
    double north = 0;  // degrees clockwise from y, or from -z where y is up
    std::vector<GivenFlag> given;
};

}  // namespace sunfleck::engine
