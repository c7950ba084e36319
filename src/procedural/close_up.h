// CloseUp: one of several cameras of a scene, ever closer to something.
#pragma once

#include <string_view>

namespace sunfleck::engine {

/// Numbers are stored as text, as in the scene file.
struct CloseUp {
    std::string_view name;
    std::string_view what;
    std::string_view target;  // point at the centre of the picture, cm
    std::string_view fov;     // degrees
};

}  // namespace sunfleck::engine
