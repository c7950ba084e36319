// The scenes keyhole-4, -6, -8, -9 and keyhole-lamp: light through a small hole, far from the
// visible points.
//
// A closed black box contains a pane of milk glass and, 80 cm below it, a diffuse floor. The camera
// sees 41 x 41 cm of the floor and nothing else. Light enters through a square hole in the roof, 4
// m before the pane, hits the pane within its edges, and is transmitted to the floor. The pane does
// not reflect, and everything else is black. So all visible light has been scattered twice, at any
// maximum depth, and the brightness of the picture is known: tests/support/keyhole_truth.h.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

enum class KeyholeLight { sun, lamp };

/// One of the scenes, or a variant.
struct Keyhole {
    std::string_view name;
    std::string_view what;
    /// Side of the square hole in m; the visible fraction is proportional to its square.
    double width;
    KeyholeLight light;
    /// Luminance of the sun's irradiance on a perpendicular plane, or of the lamp's radiance; both
    /// are white.
    int strength;
};

/// Visible fractions for discs of radius zero: 9.9e-5, 1.0e-6, 1.0e-8, 1.0e-9 and 1.0e-6. The sun
/// is stronger for smaller holes: the five pictures are equally bright within 3%.
inline constexpr std::array<Keyhole, 5> kKeyholes = {{
    {"keyhole-4", "sun through a hole far from the view; 1e-4 of its photon paths are seen", 0.25,
     KeyholeLight::sun, 160},
    {"keyhole-6", "the same, the hole 2.5 cm wide: 1e-6", 0.025, KeyholeLight::sun, 16'000},
    {"keyhole-8", "the same, the hole 2.5 mm wide: 1e-8", 0.0025, KeyholeLight::sun, 1'600'000},
    {"keyhole-9", "the same, the hole .8 mm wide: 1e-9", 0.00079057, KeyholeLight::sun, 16'000'000},
    {"keyhole-lamp", "a lamp above the hole of keyhole-6 in place of the sun: 1e-6", 0.025,
     KeyholeLight::lamp, 15'680'000},
}};

/// Dimensions that all of them share. Unit: metres; z is up; the centre of the hole is at x = y =
/// 0.
struct KeyholeRoom {
    std::array<float, 3> low = {-1, -1.2F, 0};    // of the box; the floor is at z = 0
    std::array<float, 3> high = {3.2F, 1.2F, 4};  // the roof is at high[2]
    Vec3d way{0.6, 0, -0.8};                      // unit vector from the sun or the lamp's centre
    double pane_x = 2.4;                          // below the pane's centre, y = 0
    double pane_height = 0.8;
    double pane_width = 0.32;
    double transmittance = 0.8;  // of the pane, diffuse
    double reflectance = 0.5;    // of the floor
    double camera_height = 0.5;  // above the same point, looking down
    double field_of_view = 45;   // in degrees, of the square picture
    double lamp_distance = 2.8;  // from the hole, against the direction of light
    double lamp_width = 0.1;     // side of the horizontal square, facing down
};

inline constexpr KeyholeRoom kKeyholeRoom;

/// Returns one file.
std::vector<SceneFile> keyhole_scene(const Keyhole& keyhole);

/// Returns walls and roof with outward normals: with keyhole_floor() a closed surface, except for
/// the hole.
Mesh keyhole_walls(double hole_width);
Mesh keyhole_floor();

}  // namespace sunfleck::engine
