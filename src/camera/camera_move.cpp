// Turns of the frame about the pivot, then steps along its axes.
#include "camera/camera_move.h"

#include "camera/camera_frame.h"
#include "camera/screen.h"

#include <cmath>
#include <type_traits>

namespace sunfleck::engine {
namespace {

/// Returns the axis of the world that is nearest to a direction, on its side.
Vec3d nearest_axis(const Vec3d& direction) {
    int nearest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(direction[axis]) > std::abs(direction[nearest])) nearest = axis;
    Vec3d result(0);
    result[nearest] = std::copysign(1.0, direction[nearest]);
    return result;
}

Matrix turned(const Matrix& frame, const Vec3d& axis, double angle, const Vec3d& pivot) {
    Matrix there;
    there.setTranslation(-pivot);
    Matrix turn;
    turn.setAxisAngle(axis, angle);
    Matrix back;
    back.setTranslation(pivot);
    return frame * there * turn * back;
}

/// Returns a direction of the camera as a unit vector of the world.
Vec3d axis_of(const Matrix& frame, const Vec3d& local) {
    return sunfleck::engine::turn(frame, local).normalized();
}

}  // namespace

Camera moved(const Camera& camera, const CameraMove& move, double distance) {
    const Matrix& before = frame_of(camera);
    const Vec3d pivot = before.translation() + axis_of(before, {0, 0, 1}) * distance;
    const Vec3d upright = nearest_axis(axis_of(before, {0, 1, 0}));
    Matrix frame = turned(before, axis_of(before, {1, 0, 0}), move.tilt, pivot);
    frame = turned(frame, upright, move.turn, pivot);
    const bool is_parallel = std::holds_alternative<OrthographicCamera>(camera);
    const double left = std::exp2(-move.nearer);  // of the distance
    const Vec3d step = axis_of(frame, {0, 0, 1}) * (is_parallel ? 0 : distance * (1 - left)) +
                       axis_of(frame, {1, 0, 0}) * (distance * left * move.beside.x) +
                       axis_of(frame, {0, 1, 0}) * (distance * left * move.beside.y);
    for (int axis = 0; axis < 3; ++axis) frame[3][axis] += step[axis];
    const Vec3d place = frame.translation();
    frame = turned(frame, axis_of(frame, {1, 0, 0}), move.pitch, place);
    frame = turned(frame, upright, move.yaw, place);

    Camera result = camera;
    std::visit([&](auto& one) { one.camera_to_world = frame; }, result);
    if (is_parallel) {
        auto& screen = std::get<OrthographicCamera>(result);
        screen.screen_min *= left;
        screen.screen_max *= left;
    }
    return result;
}

bool has_lens(const Camera& camera) {
    return std::visit(
        [](const auto& one) {
            if constexpr (std::is_base_of_v<ScreenCamera, std::decay_t<decltype(one)>>)
                return one.lens_radius > 0;
            return false;
        },
        camera);
}

Camera focused(const Camera& camera, const Vec3d& point) {
    Camera result = camera;
    if (!has_lens(camera)) return result;
    const double depth = (point * frame_of(camera).inverse()).z;
    std::visit(
        [&](auto& one) {
            if constexpr (std::is_base_of_v<ScreenCamera, std::decay_t<decltype(one)>>)
                if (depth > 0) one.focal_distance = depth;
        },
        result);
    return result;
}

}  // namespace sunfleck::engine
