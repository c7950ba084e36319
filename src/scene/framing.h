// Cameras that importers place themselves: by axes, and so that they see a whole scene.
#pragma once

#include "geometry/bounds.h"
#include "scene/description.h"

namespace sunfleck::engine {

/// Pixels of a picture where the scene says no number.
inline constexpr Vec2i kUsualResolution{1280, 720};

/// Returns the frame of a camera, which is left-handed: its z looks ahead. Lengths of the axes do
/// not matter.
Matrix camera_frame(const Vec3d& right, const Vec3d& up, const Vec3d& ahead, const Vec3d& place);

/// Returns a camera whose picture is `yfov` high. @param yfov  in radians, in (0, pi).
PerspectiveCamera perspective_view(const Matrix& to_world, double yfov, const Vec2i& resolution);

/// Returns bounds of all shapes and instances, in the world.
Bounds bounds_of_scene(const SceneDescription& scene);

/// A direction of view, and how much of the picture things fill.
struct Framing {
    Vec3d towards_camera{0, 0, 1};  // from what is seen; not along `up`
    Vec3d up{0, 1, 0};
    double yfov = kPiDouble / 6;  // radians
    double fill = 0.8;            // part of width or height that the box takes at most
};

/// Returns the nearest camera of that direction that has all corners of a box in the picture, in
/// the middle of its height and width.
/// @param box  not empty.
PerspectiveCamera camera_that_sees(const Bounds& box, const Framing& framing,
                                   const Vec2i& resolution);

}  // namespace sunfleck::engine
