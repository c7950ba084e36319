// A camera moved from its place by who looks through it: around what it sees, nearer, aside.
#pragma once

#include "camera/camera.h"

namespace sunfleck::engine {

/// In the order in which they are done. Angles are in radians.
struct CameraMove {
    double tilt = 0;    // about the camera's axis to the right, through the pivot
    double turn = 0;    // about the upright axis through the pivot
    double nearer = 0;  // powers of two by which the way to the pivot shrinks
    Vec2d beside{0};    // to the right and up, in ways to the pivot
    double pitch = 0;   // about the camera's axis to the right, in its place
    double yaw = 0;     // about the upright axis, in its place

    friend bool operator==(const CameraMove&, const CameraMove&) = default;
};

/// Returns the moved camera. Upright is the axis of the world that is nearest to what is up in the
/// picture. An orthographic camera that comes nearer sees less instead.
/// @param distance  of the pivot, which is straight ahead; positive, in the world.
Camera moved(const Camera& camera, const CameraMove& move, double distance);

/// Returns the camera with what is at a point in focus; one without a lens as it is.
/// @param point  in the camera's world.
Camera focused(const Camera& camera, const Vec3d& point);

/// Returns whether the camera has a lens, so that not all is in focus.
bool has_lens(const Camera& camera);

}  // namespace sunfleck::engine
