// Cameras: from a film point and a lens point to the first segment of a camera path.
#pragma once

#include "camera/screen_camera.h"
#include "math/vector.h"

#include <array>
#include <optional>
#include <variant>

namespace sunfleck::engine {

/// The first segment of a camera path, in double for scenes far from the origin.
struct CameraRay {
    Vec3d origin;
    Vec3d direction;  // unit vector
    /// Width of a pixel per unit distance along this ray, in the world: the square root of the
    /// solid angle (sr) of the pixel around `film`, seen from the centre of the lens.
    float footprint_angle = 0;
    /// Width of a pixel at the origin of the ray, in the world.
    float footprint = 0;

    /// Returns whether a float ray may miss what this ray hits: a pixel is less than 2^10 times as
    /// wide as the spacing of floats, in angle or position, as with a long lens far away.
    bool needs_double() const {
        constexpr double kFine = 0x1p-14;
        return footprint_angle < kFine && footprint <= kFine * origin.length();
    }
};

/// The "perspective" camera of pbrt-v4, with a thin lens.
struct PerspectiveCamera : ScreenCamera {
    /// @param film  film point in pixels from the top left corner; y points down.
    /// @param lens  in (0,1)^2; mapped to the lens by the concentric map.
    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

/// The "orthographic" camera of pbrt-v4. With a lens, each film point has its own lens around it,
/// whereas pbrt-v4 puts all lenses at the camera's origin.
struct OrthographicCamera : ScreenCamera {
    CameraRay ray(const Vec2d& film, const Vec2d& lens) const;
};

enum class SphereMap {
    equal_area,      // octahedral equal-area map: each pixel has the same solid angle
    equirectangular  // columns are azimuth, rows are the angle from +y
};

/// The "spherical" camera of pbrt-v4: all directions from one point; y is up in camera space.
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

/// Sets the screen as in pbrt-v4: [-a, a] x [-1, 1] for frame_aspect a >= 1, and [-1, 1] x [-1/a,
/// 1/a] for a < 1; `window` (x0 x1 y0 y1) overrides it.
/// @param frame_aspect  width / height, positive.
void set_screen(ScreenCamera& camera, double frame_aspect,
                const std::optional<std::array<double, 4>>& window);

/// Makes a perspective camera whose screen (set_screen()) is scaled by tan(fov / 2).
/// @param fov  angle of the shorter axis in degrees, in (0, 180).
PerspectiveCamera make_perspective(const Matrix& camera_to_world, const Vec2i& resolution,
                                   double fov, double frame_aspect,
                                   const std::optional<std::array<double, 4>>& screen_window);

/// Changes the resolution. The screen keeps its centre and its shorter axis.
void set_resolution(Camera& camera, const Vec2i& resolution);

}  // namespace sunfleck::engine
