// Look: another view of the scene than the one that is rendered, which a viewer has asked for.
#pragma once

#include "camera/camera_move.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace sunfleck::engine {

struct Look {
    std::optional<std::array<double, 4>> region;  // x0 x1 y0 y1 as shares of the picture
    CameraMove move;
    std::optional<Vec2d> focus;  // shares of the moved picture: what is in focus there
    bool is_moving = false;      // another one comes at once: a sketch will do
};

/// Parameters of a request, by name.
using LiveParameters = std::multimap<std::string, std::string>;

/// Reads region=X0,X1,Y0,Y1, tilt, turn, nearer, right, up, pitch, yaw, focus_x with focus_y, and
/// moving=1. What is not given is as in the picture that is rendered.
/// @throws Error for what is no number, or none that makes sense.
Look read_look(const LiveParameters& parameters);

}  // namespace sunfleck::engine
