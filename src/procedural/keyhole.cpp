// A box of black sheets with a hole in its roof, a pane of milk glass, a floor, the sun or a lamp.

#include "procedural/keyhole.h"

#include "procedural/placement.h"
#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: metres; z is up",
                             R"(LookAt 2.4 0 0.5  2.4 0 0  0 1 0
Camera "perspective" "float fov" 45
)",
                             256, 256, 8};

constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "black" "string type" "diffuse" "rgb reflectance" [ 0 0 0 ]
MakeNamedMaterial "floor" "string type" "diffuse" "rgb reflectance" [ 0.5 0.5 0.5 ]
MakeNamedMaterial "milk-glass" "string type" "diffusetransmission"
    "rgb reflectance" [ 0 0 0 ] "rgb transmittance" [ 0.8 0.8 0.8 ]
)";

constexpr std::string_view kSun = R"(
# The sun, white: perpendicular irradiance @STRENGTH@.
LightSource "distant" "point3 from" [ -0.6 0 0.8 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 1 1 ] "float scale" @STRENGTH@
)";

constexpr std::string_view kLamp = R"(
# The lamp, outside: white, facing down.
AttributeBegin
NamedMaterial "black"
AreaLightSource "diffuse" "rgb L" [ 1 1 1 ] "float scale" @STRENGTH@
)";

/// Four points, counter-clockwise from above.
void append_square(Mesh& mesh, const Vec3d& middle, double width) {
    const double half = width / 2;
    for (const auto& [x, y] : {std::pair(-half, -half), std::pair(half, -half),
                               std::pair(half, half), std::pair(-half, half)})
        mesh.points.push_back(rounded_point(middle + Vec3d(x, y, 0)));
}

std::string lamp_text(const KeyholeRoom& room) {
    Mesh lamp;
    const Vec3d hole(0, 0, room.high[2]);
    append_square(lamp, hole - room.way * room.lamp_distance, room.lamp_width);
    lamp.add_quad(0, 3, 2, 1);
    return std::string(kLamp) + shape_text(lamp) + "AttributeEnd\n";
}

}  // namespace

Mesh keyhole_walls(double hole_width) {
    const KeyholeRoom& room = kKeyholeRoom;
    Mesh walls;
    walls.points = box_mesh(room.low, room.high).points;  // bit 0 is x, bit 1 is y, bit 2 is z
    append_square(walls, {0, 0, room.high[2]}, hole_width);
    walls.add_quad(0, 1, 5, 4);
    walls.add_quad(2, 6, 7, 3);
    walls.add_quad(0, 4, 6, 2);
    walls.add_quad(1, 3, 7, 5);
    // The roof is a frame of four trapezoids.
    constexpr std::array<std::uint32_t, 4> kAround = {4, 5, 7, 6};
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        walls.add_quad(kAround.at(i), kAround.at(j), 8 + j, 8 + i);
    }
    return walls;
}

Mesh keyhole_floor() {
    Mesh floor;
    const auto corners = box_mesh(kKeyholeRoom.low, kKeyholeRoom.high).points;
    floor.points.assign(corners.begin(), corners.begin() + 4);
    floor.add_quad(0, 2, 3, 1);
    return floor;
}

std::vector<SceneFile> keyhole_scene(const Keyhole& keyhole) {
    const KeyholeRoom& room = kKeyholeRoom;
    SceneFolder folder({std::string(keyhole.name), std::string(keyhole.what)}, kHead);
    const std::string strength = std::to_string(keyhole.strength);
    const bool has_sun = keyhole.light == KeyholeLight::sun;
    folder.text(kMaterials);
    folder.text(replaced(has_sun ? std::string(kSun) : lamp_text(room), "@STRENGTH@", strength));
    folder.add("walls and roof, with the hole", "black", keyhole_walls(keyhole.width));
    folder.add("floor", "floor", keyhole_floor());
    Mesh pane;
    append_square(pane, {room.pane_x, 0, room.pane_height}, room.pane_width);
    pane.add_quad(0, 1, 2, 3);
    folder.add("pane", "milk-glass", pane);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
