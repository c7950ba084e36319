// Two rooms side by side, a door between them, a lamp in the one that is not seen.

#include "procedural/cornell_door.h"

#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: centimetres; z is up",
                             R"(LookAt 0 -390 137  0 0 137  0 0 1
Camera "perspective" "float fov" 38
)",
                             512, 512, 24};

constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [ 0.74 0.73 0.7 ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.6 0.06 0.05 ]
MakeNamedMaterial "green" "string type" "diffuse" "rgb reflectance" [ 0.14 0.45 0.1 ]
MakeNamedMaterial "door" "string type" "diffuse" "rgb reflectance" [ 0.42 0.26 0.14 ]
MakeNamedMaterial "brass" "string type" "conductor" "spectrum eta" "metal-CuZn-eta"
    "spectrum k" "metal-CuZn-k" "float roughness" 0.02

# The lamp under the ceiling of the other room, its only light, facing down.
AttributeBegin
NamedMaterial "white"
AreaLightSource "diffuse" "rgb L" [ 1 0.9 0.75 ] "float scale" 450
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 240 100 274  240 180 274  340 180 274  340 100 274 ]
AttributeEnd
)";

// The doorway in the wall between the rooms (its middle plane x = 145): from y = 95 to 185.
constexpr double kNear = 95;
constexpr double kFar = 185;
constexpr double kTop = 205;

/// What stands around the doorway: a flat arch of three beams, in the plane of y and z.
Mesh doorway(const Polygon& around, double left, double right) {
    Placement upright;  // local x along y, local y up, local z along x
    upright.x = Vec3d(0, 1, 0);
    upright.y = Vec3d(0, 0, 1);
    upright.z = Vec3d(1, 0, 0);
    return placed(extrude(around, {}, left, right), upright);
}

/// An opening wider than the doorway by `wider` on each side, in a wall that ends `margin` before
/// the doorway, at y = `high` behind it, and at z = `low` and `top`.
Polygon arch(double wider, double margin, double low, double high, double top) {
    const double near = kNear - wider;
    const double far = kFar + wider;
    const double lintel = kTop + wider;
    return {{kNear - margin, low, 0}, {near, low, 0},          {near, lintel, 0},
            {far, lintel, 0},         {far, low, 0},           {high, low, 0},
            {high, top, 0},           {kNear - margin, top, 0}};
}

/// A box of the door's frame: x along the door from its hinges, y across it, z up.
Mesh door_part(const Vec3d& low, const Vec3d& high) {
    const Mesh part = box_mesh(rounded_point(low), rounded_point(high));
    return placed(part, turned(0.25 + kDoorOpen, {139.5, kNear + 0.5, 0}));
}

/// Panels stand out by a centimetre from both faces.
Mesh door() {
    Mesh door = door_part({0, -4, 1}, {88, 0, 204});
    for (const double face : {-5.0, -1.0}) {
        door.append(door_part({12, face, 15}, {76, face + 2, 92}));
        door.append(door_part({12, face, 112}, {76, face + 2, 190}));
    }
    return door;
}

/// On both sides of the door: a knob of 192 triangles and its plate of 52.
Mesh knobs() {
    Profile profile = {{0, -1}, {1.2, -0.9}, {1.2, 3}};
    append_bezier(profile, {{{2.2, 3.2}, {3.2, 4.2}, {2.4, 6.2}}}, 3);
    profile.push_back({1.2, 7});
    profile.push_back({0, 7.2});
    Mesh knob = revolve(profile, 16);
    knob.append(extrude(ellipse(3.2, 6, 14), {}, -0.5, 0.5));
    const Placement hung = turned(0.25 + kDoorOpen, {139.5, kNear + 0.5, 0});
    Mesh both = placed(knob, hung * standing(0, {81, -4, 100}));
    both.append(placed(knob, hung * standing(0.5, {81, 0, 100})));
    return both;
}

Mesh block(double turns, const Vec3d& foot, double half, double height) {
    const auto side = static_cast<float>(half);
    const Mesh box = box_mesh({-side, -side, 0}, {side, side, static_cast<float>(height)});
    return placed(box, turned(turns, foot));
}

/// Slabs end within one another, so that no two faces lie in one plane.
void add_rooms(SceneFolder& folder) {
    folder.add("floor of both rooms", "white", box_mesh({-160, -5, -10}, {450, 295, 0}));
    folder.add("ceiling", "white", box_mesh({-161, -6, 275}, {451, 296, 285}));
    folder.add("back wall", "white", box_mesh({-155, 280, -5}, {445, 290, 280}));
    folder.add("left wall", "red", box_mesh({-150, 0, -4}, {-140, 285, 279}));
    folder.add("wall with the doorway", "green", doorway(arch(0, kNear, -3, 284, 278), 140, 150));
    folder.add("right wall of the other room", "white", box_mesh({430, -4, -6}, {440, 286, 281}));
    folder.add("front wall of the other room", "white", box_mesh({145, -3, -7}, {435, 7, 282}));
}

}  // namespace

std::vector<SceneFile> cornell_door_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    folder.text(kMaterials);
    add_rooms(folder);
    Mesh casing = doorway(arch(0.4, 8, -2, kFar + 8, kTop + 8), 139, 141);
    casing.append(doorway(arch(0.4, 8, -2, kFar + 8, kTop + 8), 149, 151));
    folder.add("casing", "white", casing);
    folder.add("short block", "white", block(-0.045, {35, 75, -1}, 40, 80));
    folder.add("tall block", "white", block(0.05, {-50, 175, -1}, 42, 166));
    folder.add("door", "door", door());
    folder.add("knobs", "brass", knobs());
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
