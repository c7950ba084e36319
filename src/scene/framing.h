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
    double fill = 0.8;            // part of width or height that things take at most
};

/// Finds the nearest camera of a direction that has all points in the picture, in the middle of its
/// height and width.
class FramedView {
public:
    /// @param near  a point near those that come, for the precision of the result.
    FramedView(const Framing& framing, const Vec2i& resolution, const Vec3d& near);

    void add(const Vec3d& point);
    /// Adds all corners of a box. @param box  not empty.
    void add(const Bounds& box);
    /// @param least  distance from `near` at least. Some point must have been added.
    PerspectiveCamera camera(double least = 1e-6) const;

private:
    /// How far before the origin a camera must be for all points to be between its edges, if it is
    /// moved to neither side.
    struct Edges {
        double slope = 1;  // of the edges, times the part that is filled
        double above = -1e300;
        double below = -1e300;

        void add(double beside, double towards);
        double distance() const { return (above + below) / 2; }
        double shift() const { return (above - below) * slope / 2; }
    };

    Framing framing_;
    Vec2i resolution_;
    Vec3d near_;
    Vec3d x_;
    Vec3d y_;
    Vec3d z_;  // to the camera
    Edges wide_;
    Edges high_;
};

}  // namespace sunfleck::engine
