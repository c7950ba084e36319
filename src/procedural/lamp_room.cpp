// A furnished room, a hall beside it with a slit in its roof, and a lamp that shines at the
// ceiling.

#include "procedural/lamp_room.h"

#include "procedural/extrusion.h"
#include "procedural/furniture.h"
#include "procedural/placement.h"
#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

// What is seen ends below kLamp, the height from which the lamp shines upwards.
constexpr SceneHead kHead = {"Unit: metres; z is up",
                             R"(LookAt -1.9 -1.5 1.7  0.6 0.7 0.43  0 0 1
Camera "perspective" "float fov" 40
)",
                             256, 256, 32};

constexpr std::string_view kSun = R"(
# The sun, 50 degrees high: perpendicular irradiance 16, on all of the ground.
LightSource "distant" "point3 from" [ 0.02 0.64 0.77 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.95 0.88 ] "float scale" 16
)";

constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "ground" "string type" "diffuse" "rgb reflectance" [ 0.3 0.32 0.26 ]
MakeNamedMaterial "plaster" "string type" "diffuse" "rgb reflectance" [ 0.8 0.78 0.74 ]
MakeNamedMaterial "boards" "string type" "diffuse" "rgb reflectance" [ 0.5 0.4 0.3 ]
MakeNamedMaterial "wood" "string type" "diffuse" "rgb reflectance" [ 0.45 0.28 0.16 ]
MakeNamedMaterial "paper" "string type" "diffuse" "rgb reflectance" [ 0.65 0.25 0.2 ]
MakeNamedMaterial "cloth" "string type" "diffuse" "rgb reflectance" [ 0.2 0.3 0.5 ]
MakeNamedMaterial "clay" "string type" "diffuse" "rgb reflectance" [ 0.62 0.3 0.17 ]
)";

constexpr std::string_view kLampLight = R"(
# The lamp: a bright strip on a board below the ceiling, facing up; a hundredth of the sun's power.
AttributeBegin
NamedMaterial "plaster"
AreaLightSource "diffuse" "rgb L" [ 1 0.85 0.65 ] "float scale" 356
)";

constexpr double kRoomEast = 2.5;
constexpr double kHallWest = -4.2;
constexpr double kHalfDepth = 2;
constexpr double kCeiling = 2.6;
constexpr float kLamp = 1.95F;
constexpr float kHalfGround = 10;

/// Local x along y, local y up, local z along x.
Placement in_the_wall() {
    return {.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {0, 0, 0}};
}

/// Slabs that end within one another; a doorway to the hall, and the slit in its roof.
void add_house(SceneFolder& folder) {
    constexpr auto kWest = static_cast<float>(kHallWest);
    constexpr auto kEast = static_cast<float>(kRoomEast);
    constexpr auto kDeep = static_cast<float>(kHalfDepth);
    constexpr float kThick = 0.2F;
    folder.add("floor", "boards",
               box_mesh({kWest - 0.3F, -kDeep - 0.3F, -0.3F}, {kEast + 0.3F, kDeep + 0.3F, 0}));
    folder.add("west wall", "plaster",
               box_mesh({kWest - kThick, -kDeep - 0.19F, -0.2F}, {kWest, kDeep + 0.19F, 2.7F}));
    folder.add("east wall", "plaster",
               box_mesh({kEast, -kDeep - 0.19F, -0.2F}, {kEast + kThick, kDeep + 0.19F, 2.7F}));
    folder.add("south wall", "plaster",
               box_mesh({kWest - 0.1F, -kDeep - kThick, -0.21F}, {kEast + 0.1F, -kDeep, 2.71F}));
    folder.add("north wall", "plaster",
               box_mesh({kWest - 0.1F, kDeep, -0.21F}, {kEast + 0.1F, kDeep + kThick, 2.71F}));
    const Polygon doorway = rectangle(-1.9, 0.002, -1, 2);
    folder.add(
        "inner-wall", "plaster",
        placed(extrude(rectangle(-2.1, -0.15, 2.1, 2.65), {doorway}, -2.7, -2.5), in_the_wall()));
    const Polygon slit = rectangle(-3.5, 0.3, -3.47, 1.5);
    folder.add("roof", "plaster",
               extrude(rectangle(kHallWest - 0.25, -kHalfDepth - 0.25, kRoomEast + 0.25,
                                 kHalfDepth + 0.25),
                       {slit}, kCeiling, kCeiling + 0.25));
}

void add_lamp(SceneFolder& folder) {
    folder.add("board", "wood", box_mesh({0.9F, -2.1F, 1.9F}, {2.1F, -1.7F, kLamp}));
    folder.text(kLampLight);
    Mesh strip;
    strip.points = {{1, -1.9F, 1.97F}, {2, -1.9F, 1.97F}, {2, -1.8F, 1.97F}, {1, -1.8F, 1.97F}};
    strip.add_quad(0, 1, 2, 3);
    folder.text(shape_text(strip) + "AttributeEnd\n");
}

void add_furniture(SceneFolder& folder) {
    const Placement table = at({0.5, 0.6, 0});
    folder.add("low-table", "wood", placed(round_table(), table));
    folder.add("clay-bowl", "clay", placed(bowl(), table * at({0, 0, 0.441})));
    folder.add("paper-fruit", "paper", placed(fruit(), table * at({0, 0, 0.441})));
    const Placement seat = turned(-0.25, {2.05, 0.2, 0});
    const Seat sofa_mesh = sofa(2);
    folder.add("cushions", "cloth", placed(sofa_mesh.cloth, seat));
    folder.add("sofa-frame", "wood", placed(sofa_mesh.wood, seat));
    folder.add("stool", "wood", box_mesh({-0.9F, 1.2F, -0.02F}, {-0.45F, 1.6F, 0.42F}));
}

}  // namespace

std::vector<SceneFile> lamp_room_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    if (scene.name == "useless-light") folder.text(kSun);
    folder.text(kMaterials);
    folder.add("ground", "ground", square_mesh(kHalfGround, -0.1F));
    add_house(folder);
    add_lamp(folder);
    add_furniture(folder);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
