// The scenes keyhole-4, -6, -8, -9 and keyhole-lamp: light through one small hole, far from the
// view.
//
// A closed black box holds nothing but a pane of milk glass and, 80 cm below it, a diffuse floor,
// of which the camera sees 41 x 41 cm and nothing else. Light comes in through a square hole in the
// roof, 4 m from the pane along its way, falls on the pane within its edges, and shines through it
// on the floor. The pane throws nothing back and all else is black, so all light in view has been
// scattered twice, whatever depth is allowed, and how bright the picture is is known:
// tests/support/keyhole_truth.h.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

enum class KeyholeLight { sun, lamp };

/// One of the scenes, or another of their kind.
struct Keyhole {
    std::string_view name;
    std::string_view what;
    /// Side of the square hole, m: the number that sets the visible fraction, by its square.
    double width;
    KeyholeLight light;
    /// Luminance of the sun's irradiance on a plane across its way, or of the lamp's radiance; both
    /// are white.
    int strength;
};

/// Fractions of uniform photon paths that can be seen, for discs of no
/// width: 9.9e-5, 1.0e-6, 1.0e-8, 1.0e-9 and 1.0e-6. The sun grows as the hole shrinks: the five
/// pictures are equally bright within 3%.
inline constexpr std::array<Keyhole, 5> kKeyholes = {{
    {"keyhole-4", "sun through a hole far from the view; 1e-4 of its photon paths are seen", 0.25,
     KeyholeLight::sun, 160},
    {"keyhole-6", "the same, the hole 2.5 cm wide: 1e-6", 0.025, KeyholeLight::sun, 16'000},
    {"keyhole-8", "the same, the hole 2.5 mm wide: 1e-8", 0.0025, KeyholeLight::sun, 1'600'000},
    {"keyhole-9", "the same, the hole .8 mm wide: 1e-9", 0.00079057, KeyholeLight::sun, 16'000'000},
    {"keyhole-lamp", "a lamp above the hole of keyhole-6 in place of the sun: 1e-6", 0.025,
     KeyholeLight::lamp, 15'680'000},
}};

/// What all of them share. Metres, z up; the hole's middle is at x = y = 0.
struct KeyholeRoom {
    std::array<float, 3> low = {-1, -1.2F, 0};    // of the box; the floor is at z = 0
    std::array<float, 3> high = {3.2F, 1.2F, 4};  // the roof is at high[2]
    Vec3d way{0.6, 0, -0.8};                      // unit; from the sun or the lamp's middle
    double pane_x = 2.4;                          // below the pane's middle, y = 0
    double pane_height = 0.8;
    double pane_width = 0.32;
    double transmittance = 0.8;  // of the pane, diffuse
    double reflectance = 0.5;    // of the floor
    double camera_height = 0.5;  // over the same point, looking down
    double field_of_view = 45;   // degrees, of the square picture
    double lamp_distance = 2.8;  // from the hole, against the way
    double lamp_width = 0.1;     // square, level, facing down
};

inline constexpr KeyholeRoom kKeyholeRoom;

/// One file.
std::vector<SceneFile> keyhole_scene(const Keyhole& keyhole);

/// Walls and roof, normals out: with keyhole_floor() a closed surface but for the hole.
Mesh keyhole_walls(double hole_width);
Mesh keyhole_floor();

}  // namespace sunfleck::engine
