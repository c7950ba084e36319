// A hall of stone with two arched windows in its right wall: each with a pane of glass, or open and
// the hall full of mist.

#include "procedural/two_windows.h"

#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {.unit = "Unit: metres; z is up",
                             .camera = R"(LookAt 3.3 0.25 2.4  -0.4 5.6 0.95  0 0 1
Camera "perspective" "float fov" 62
)",
                             .width = 512,
                             .height = 512,
                             .max_depth = 24};

constexpr std::string_view kMaterials = R"(
# The sun, 40 degrees high, the only light: perpendicular irradiance 45.
LightSource "distant" "point3 from" [ 0.75 -0.14 0.65 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.93 0.82 ] "float scale" 45

Texture "tiles" "spectrum" "checkerboard" "string mapping" "planar"
    "vector3 v1" [ 1.25 0 0 ] "vector3 v2" [ 0 1.25 0 ]
    "rgb tex1" [ 0.78 0.74 0.66 ] "rgb tex2" [ 0.5 0.43 0.36 ]
MakeNamedMaterial "tiles" "string type" "diffuse" "texture reflectance" "tiles"
MakeNamedMaterial "ground" "string type" "diffuse" "rgb reflectance" [ 0.3 0.32 0.26 ]
MakeNamedMaterial "stone" "string type" "diffuse" "rgb reflectance" [ 0.84 0.81 0.75 ]
MakeNamedMaterial "wood" "string type" "diffuse" "rgb reflectance" [ 0.48 0.29 0.16 ]
MakeNamedMaterial "cloth" "string type" "diffuse" "rgb reflectance" [ 0.55 0.09 0.08 ]
MakeNamedMaterial "clay" "string type" "diffuse" "rgb reflectance" [ 0.62 0.3 0.17 ]
MakeNamedMaterial "pane" "string type" "dielectric" "float eta" 1.5
)";

// The hall: x from -4 to 4, y from 0 to 9, z from 0 to 4.8, its walls 40 cm thick.
constexpr std::array<double, 2> kWindows = {2.1, 6.9};  // y of their centres
constexpr double kHalfWindow = 0.6;

/// Maps local x along y, local y up, local z along x.
Placement in_the_wall() {
    return {.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {0, 0, 0}};
}

Polygon window(double middle, double margin) {
    return arched(middle - kHalfWindow - margin, 1.1 - margin, middle + kHalfWindow + margin, 3.1,
                  24);
}

/// Thin mist, whose border ends within the walls.
constexpr std::string_view kMist = R"(
MakeNamedMedium "mist" "string type" "homogeneous"
    "spectrum sigma_s" [ 300 0.1 900 0.1 ] "spectrum sigma_a" [ 300 0.003 900 0.003 ] "float g" 0.6
AttributeBegin
MediumInterface "mist" ""
)";
/// Towards the windows, for mist scatters forward.
constexpr std::string_view kEyeInMist = R"(MediumInterface "" "mist"
LookAt -3.5 0.6 1.5  3.2 6 2  0 0 1
Camera "perspective" "float fov" 62
)";
constexpr std::string_view kNoMist = R"(MediumInterface "" ""
MakeNamedMaterial "nothing" "string type" "interface"
)";

void add_mist(SceneFolder& folder) {
    folder.text(kMist);
    folder.add("border of the mist", "nothing",
               box_mesh({-4.05F, -0.05F, -0.05F}, {4.2F, 9.05F, 4.85F}));
    folder.text("AttributeEnd\n");
}

void add_walls(SceneFolder& folder) {
    folder.add("floor", "tiles", box_mesh({-4.5F, -0.5F, -0.3F}, {4.5F, 9.5F, 0}));
    folder.add("ceiling", "stone", box_mesh({-4.52F, -0.52F, 4.8F}, {4.52F, 9.52F, 5.2F}));
    folder.add("left wall", "stone", box_mesh({-4.4F, -0.4F, -0.2F}, {-4, 9.4F, 5}));
    folder.add("back wall", "stone", box_mesh({-4.2F, 9, -0.21F}, {4.2F, 9.41F, 5.01F}));
    folder.add("front wall", "stone", box_mesh({-4.2F, -0.41F, -0.21F}, {4.2F, 0, 5.01F}));
    const Polygon wall = rectangle(-0.45, -0.22, 9.45, 5.02);
    folder.add("right-wall", "stone",
               placed(extrude(wall, {window(kWindows[0], 0), window(kWindows[1], 0)}, 4, 4.4),
                      in_the_wall()));
}

void add_panes(SceneFolder& folder) {
    for (const double middle : kWindows)
        folder.add(middle < 5 ? "near-pane" : "far-pane", "pane",
                   placed(extrude(window(middle, 0.02), {}, 4.197, 4.203), in_the_wall()));
}

void add_beams(SceneFolder& folder) {
    Mesh beams;
    for (int i = 0; i < 5; ++i) {
        const float y = 0.75F + 1.85F * static_cast<float>(i);
        beams.append(box_mesh({-4.1F, y - 0.14F, 4.45F}, {4.1F, y + 0.14F, 4.9F}));
    }
    folder.add("beams", "wood", beams);
}

Mesh column() {
    Profile profile = {{0, -0.1}, {0.36, -0.1}, {0.36, 0.12}};
    append_bezier(profile, {{{0.42, 0.16}, {0.4, 0.3}, {0.29, 0.32}}}, 12);
    append_bezier(profile, {{{0.3, 1.4}, {0.27, 2.6}, {0.24, 3.5}}}, 24);
    append_bezier(profile, {{{0.26, 3.7}, {0.46, 3.7}, {0.48, 3.92}}}, 12);
    profile.push_back({0.48, 4.6});
    profile.push_back({0, 4.6});
    return revolve(profile, 72);
}

Mesh vase() {
    Profile profile = {{0, 0}, {0.13, 0}};
    append_bezier(profile, {{{0.38, 0.25}, {0.3, 0.55}, {0.1, 0.68}}}, 24);
    append_bezier(profile, {{{0.09, 0.74}, {0.1, 0.78}, {0.15, 0.82}}}, 10);
    append_bezier(profile, {{{0.13, 0.8}, {0.07, 0.75}, {0.08, 0.68}}}, 10);
    append_bezier(profile, {{{0.25, 0.5}, {0.3, 0.25}, {0, 0.05}}}, 20);
    return revolve(profile, 64);
}

Mesh legs(const Vec3d& low, const Vec3d& high, double thick) {
    Mesh legs;
    for (const double x : {low.x, high.x - thick})
        for (const double y : {low.y, high.y - thick})
            legs.append(box_mesh(rounded_point({x, y, low.z}),
                                 rounded_point({x + thick, y + thick, high.z})));
    return legs;
}

void add_furniture(SceneFolder& folder) {
    Mesh columns;
    for (const double y : {2.6, 5.7, 8.1}) columns.append(placed(column(), at({-2.7, y, 0})));
    folder.add("columns", "stone", columns);
    Mesh bench = box_mesh({0.7F, 2.3F, 0.42F}, {1.2F, 4.4F, 0.48F});
    bench.append(legs({0.74, 2.35, -0.05}, {1.16, 4.35, 0.45}, 0.07));
    Mesh table = box_mesh({0.4F, 6.7F, 0.86F}, {1.5F, 8.4F, 0.92F});
    table.append(legs({0.46, 6.76, -0.05}, {1.44, 8.34, 0.9}, 0.09));
    bench.append(table);
    folder.add("bench-and-table", "wood", bench);
    folder.add("cushion", "cloth",
               placed(superellipsoid({0.23, 0.32, 0.075}, 0.45F, 64, 32), at({0.95, 3.7, 0.55})));
    folder.add("vase", "clay", placed(vase(), at({0.95, 7.45, 0.921})));
    folder.add("jar", "clay", placed(vase(), at({-1.5, 8.2, 0.001})));
}

}  // namespace

std::vector<SceneFile> two_windows_scene(const ProceduralScene& scene) {
    const bool is_misty = scene.name == "light-shafts";
    SceneHead head = kHead;
    if (is_misty) head.camera = kEyeInMist;
    SceneFolder folder(scene, head);
    if (is_misty) folder.text(kNoMist);
    folder.text(kMaterials);
    folder.add("ground", "ground",
               placed(square_mesh(static_cast<float>(kGroundHalfWidth), -0.13F), at({0, 4.5, 0})));
    add_walls(folder);
    is_misty ? add_mist(folder) : add_panes(folder);
    add_beams(folder);
    add_furniture(folder);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
