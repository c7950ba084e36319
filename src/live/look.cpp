// Each number within limits of its own.
#include "live/look.h"

#include "flags/values.h"

namespace sunfleck::engine {
namespace {

std::optional<std::string> text_of(const LiveParameters& parameters, const std::string& name) {
    const auto found = parameters.find(name);
    if (found == parameters.end()) return {};
    return found->second;
}

/// Returns a number in [-most, most]; zero where none is given.
double number_of(const LiveParameters& parameters, const std::string& name, double most) {
    const auto text = text_of(parameters, name);
    return text ? read_number(*text, name, -most, most) : 0;
}

}  // namespace

Look read_look(const LiveParameters& parameters) {
    constexpr double kMostTurn = 1000;         // radians
    constexpr double kMostTilt = kPiDouble;    // radians
    constexpr double kMostNearer = 20;         // powers of two
    constexpr double kMostBeside = 1'000'000;  // ways to the pivot
    Look look;
    if (const auto region = text_of(parameters, "region"))
        look.region = read_crop_window(*region, "region");
    look.move = {.tilt = number_of(parameters, "tilt", kMostTilt),
                 .turn = number_of(parameters, "turn", kMostTurn),
                 .nearer = number_of(parameters, "nearer", kMostNearer),
                 .beside = {number_of(parameters, "right", kMostBeside),
                            number_of(parameters, "up", kMostBeside)},
                 .pitch = number_of(parameters, "pitch", kMostTilt),
                 .yaw = number_of(parameters, "yaw", kMostTurn)};
    const auto x = text_of(parameters, "focus_x");
    const auto y = text_of(parameters, "focus_y");
    if (x && y)
        look.focus = Vec2d(read_number(*x, "focus_x", 0, 1), read_number(*y, "focus_y", 0, 1));
    look.is_moving = text_of(parameters, "moving") == "1";
    return look;
}

}  // namespace sunfleck::engine
