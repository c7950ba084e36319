// Cameras: from a point of the film, and one of the lens, to the first segment of a camera path.
#pragma once

#include "camera/screen_camera.h"
#include "math/vector.h"

#include <array>
#include <optional>
#include <variant>

namespace sunfleck::engine {

/// A camera path's first segment, in double: far worlds need it.
struct CameraRay {
    Vec3d origin;
    Vec3d direction;  // unit
    /// Width of a pixel per unit distance along this ray: square root of the solid angle (sr) that
    /// the pixel around `film` spans at the centre of the lens, in the world.
    float footprint_angle = 0;
    /// Width of a pixel where the ray starts, in the world.
    float footprint = 0;

    /// Would a ray of floats go beside what this one meets? True if a pixel is less than 2^10 times
    /// as wide as the steps of floats, in angle or in place: through a long lens from afar.
    bool needs_double() const {
        constexpr double kFine = 0x1p-14;
        return footprint_angle < kFine && footprint <= kFine * origin.length();
    }
};

/// pbrt-v4's "perspective": rays through the middle of a thin lens.
struct PerspectiveCamera : ScreenCamera {
    /// @param film  in pixels from the top left corner of the film; y grows downwards.
    /// @param lens  in (0,1)^2; concentric map to the lens.
    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

/// pbrt-v4's "orthographic": parallel rays. With a lens, each film point has a lens of its own
/// around it (pbrt-v4 puts all of them at the camera's origin, as in perspective).
struct OrthographicCamera : ScreenCamera {
    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

enum class SphereMap {
    equal_area,      // the whole sphere by equal-area octahedra: each pixel the same solid angle
    equirectangular  // columns are azimuth, rows the angle from +y
};

/// pbrt-v4's "spherical": all directions from one point; y is up in the camera frame.
struct SphericalCamera {
    Matrix camera_to_world;
    Vec2i resolution{1280, 720};
    SphereMap map = SphereMap::equal_area;

    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

using Camera = std::variant<PerspectiveCamera, OrthographicCamera, SphericalCamera>;

inline CameraRay camera_ray(const Camera& camera, const Vec2d& film, const Vec2d& lens) {
    return std::visit([&](const auto& c) { return c.ray(film, lens); }, camera);
}

/// The screen of pbrt-v4: [-a, a] x [-1, 1] for frame_aspect a >= 1, and [-1, 1] x [-1/a, 1/a] for
/// a < 1; `window` (x0 x1 y0 y1) overrides it. @param frame_aspect  width / height, positive.
void set_screen(ScreenCamera& camera, double frame_aspect,
                const std::optional<std::array<double, 4>>& window);

/// A perspective camera whose screen (set_screen()) is scaled by tan(fov / 2), `fov` in degrees:
/// the angle of the shorter axis. @param fov  in (0, 180).
PerspectiveCamera make_perspective(const Matrix& camera_to_world, const Vec2i& resolution,
                                   double fov, double frame_aspect,
                                   const std::optional<std::array<double, 4>>& screen_window);

/// Changes the picture's size. A screen keeps its middle and its shorter axis.
void set_resolution(Camera& camera, const Vec2i& resolution);

}  // namespace sunfleck::engine
