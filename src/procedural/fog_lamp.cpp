// Two chambers full of fog, a door with a keyhole between them, a lamp in one, the camera in the
// other.

#include "procedural/fog_lamp.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/furniture.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kFogLampHead = {.unit = "Unit: metres; z is up",
                                    .camera = R"(MediumInterface "" "fog"
LookAt 1.8 -2.32 1.22  1.1 0.3 0.98  0 0 1
Camera "perspective" "float fov" 56
)",
                                    .width = 512,
                                    .height = 512,
                                    .max_depth = 32};

constexpr std::string_view kFogLampMaterials = R"(
MakeNamedMaterial "nothing" "string type" "interface"
MakeNamedMaterial "floor" "string type" "diffuse" "rgb reflectance" [ 0.42 0.33 0.25 ]
MakeNamedMaterial "plaster" "string type" "diffuse" "rgb reflectance" [ 0.45 0.43 0.4 ]
MakeNamedMaterial "door" "string type" "diffuse" "rgb reflectance" [ 0.36 0.2 0.11 ]
MakeNamedMaterial "iron" "string type" "diffuse" "rgb reflectance" [ 0.12 0.12 0.13 ]
MakeNamedMaterial "table" "string type" "diffuse" "rgb reflectance" [ 0.5 0.3 0.17 ]
MakeNamedMaterial "porcelain" "string type" "diffuse" "rgb reflectance" [ 0.8 0.8 0.78 ]
)";

/// The border of the fog lies within the walls of both chambers.
constexpr std::string_view kFog = R"(
# Fog: a mean free path of four and a half metres; white.
MakeNamedMedium "fog" "string type" "homogeneous"
    "spectrum sigma_s" [ 300 0.22 900 0.22 ] "spectrum sigma_a" [ 300 0.003 900 0.003 ]
    "float g" 0.3
AttributeBegin
MediumInterface "fog" ""
)";

constexpr std::string_view kFogLampLight = R"(
# The lamp, in the chamber behind the door: a ball of 5 cm.
AttributeBegin
Translate -1.1 0 1.83
NamedMaterial "iron"
AreaLightSource "diffuse" "rgb L" [ 1 0.84 0.62 ] "float scale" 300000
Shape "sphere" "float radius" 0.025
AttributeEnd
)";

// The room: x from 0 to 4.2, y from -2.4 to 1.6; the chamber: x from -2.2 to -0.2. Both are 2.4 m
// high.
constexpr double kKeyholeHeight = 1.42;

/// Maps local x along y, local y up, local z along x.
Placement across_the_beam() {
    return {.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {0, 0, kKeyholeHeight}};
}

/// Returns a round hole above a slot that widens downwards, counter-clockwise.
Polygon keyhole_outline() {
    constexpr double kRadius = 0.05;
    constexpr std::size_t kSteps = 24;
    Polygon outline = {{-0.042, -0.135, 0}, {0.042, -0.135, 0}};
    for (std::size_t i = 0; i <= kSteps; ++i) {  // from 60 degrees right of straight down
        const double share = static_cast<double>(i) / static_cast<double>(kSteps);
        const SinCos t = sin_cos_2pi(-0.18 + 0.86 * share);
        outline.emplace_back(kRadius * t.cos, kRadius * t.sin, 0);
    }
    return outline;
}

void add_fog(SceneFolder& folder) {
    folder.text(kFog);
    folder.add("border of the fog", "nothing",
               box_mesh({-2.3F, -2.49F, -0.07F}, {4.3F, 1.69F, 2.47F}));
    folder.text("AttributeEnd\n");
}

void add_chambers(SceneFolder& folder) {
    folder.add("floor", "floor", box_mesh({-2.6F, -2.8F, -0.2F}, {4.6F, 2, 0}));
    folder.add("ceiling", "plaster", box_mesh({-2.6F, -2.8F, 2.4F}, {4.6F, 2, 2.6F}));
    folder.add("far wall of the chamber", "plaster",
               box_mesh({-2.5F, -2.7F, -0.1F}, {-2.2F, 1.9F, 2.5F}));
    folder.add("far wall of the room", "plaster",
               box_mesh({4.2F, -2.7F, -0.1F}, {4.5F, 1.9F, 2.5F}));
    folder.add("right wall", "plaster", box_mesh({-2.4F, -2.6F, -0.11F}, {4.4F, -2.4F, 2.51F}));
    folder.add("left wall", "plaster", box_mesh({-2.4F, 1.6F, -0.11F}, {4.4F, 1.8F, 2.51F}));
    const Polygon opening = rectangle(-0.13, -0.25, 0.13, 0.25);
    folder.add(
        "wall between", "plaster",
        placed(extrude(rectangle(-2.5, -1.52, 1.7, 1.08), {opening}, -0.2, 0), across_the_beam()));
}

void add_door(SceneFolder& folder) {
    folder.add("fog-door", "door",
               placed(extrude(rectangle(-0.5, -kKeyholeHeight + 0.003, 0.45, 0.65),
                              {keyhole_outline()}, -0.01, 0.03),
                      across_the_beam()));
    Mesh panels;
    for (const double low : {-1.25, 0.2})
        panels.append(
            placed(extrude(rectangle(-0.38, low, 0.33, low < 0 ? -0.35 : 0.52), {}, 0.02, 0.042),
                   across_the_beam()));
    folder.add("panels", "door", panels);
}

Mesh fog_vase() {
    Profile profile = {{0, 0}, {0.07, 0}};
    append_bezier(profile, {{{0.19, 0.13}, {0.15, 0.28}, {0.055, 0.36}}}, 24);
    append_bezier(profile, {{{0.045, 0.4}, {0.05, 0.43}, {0.085, 0.46}}}, 10);
    append_bezier(profile, {{{0.07, 0.45}, {0.035, 0.41}, {0.042, 0.36}}}, 10);
    append_bezier(profile, {{{0.13, 0.27}, {0.16, 0.14}, {0, 0.02}}}, 20);
    return revolve(profile, 64);
}

}  // namespace

std::vector<SceneFile> fog_lamp_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kFogLampHead);
    folder.text(kFogLampMaterials);
    add_chambers(folder);
    add_fog(folder);
    add_door(folder);
    folder.text(kFogLampLight);
    folder.add("fog-table", "table", placed(round_table(), at({2.15, 0, 0})));
    folder.add("fog-vase", "porcelain", placed(fog_vase(), at({2.15, 0, 0.441})));
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
