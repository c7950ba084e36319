// The room around the furniture: walls, windows, floor of boards; where each piece stands.

#include "procedural/room.h"

#include "procedural/extrusion.h"
#include "procedural/furniture.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: metres; z is up",
                             R"(LookAt -1.6 0.2 1.6  0.25 4.2 0.85  0 0 1
Camera "perspective" "float fov" 64
)",
                             512, 512, 32};

constexpr std::string_view kMaterials = R"(
# The sun, 36 degrees high, the only light: perpendicular irradiance 30.
LightSource "distant" "point3 from" [ 0.76 -0.24 0.6 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.92 0.8 ] "float scale" 30

MakeNamedMaterial "ground" "string type" "diffuse" "rgb reflectance" [ 0.3 0.32 0.26 ]
MakeNamedMaterial "plaster" "string type" "diffuse" "rgb reflectance" [ 0.84 0.82 0.77 ]
MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [ 0.85 0.85 0.83 ]
MakeNamedMaterial "boards" "string type" "diffuse" "rgb reflectance" [ 0.58 0.42 0.27 ]
MakeNamedMaterial "wood" "string type" "diffuse" "rgb reflectance" [ 0.36 0.2 0.11 ]
MakeNamedMaterial "blue" "string type" "diffuse" "rgb reflectance" [ 0.2 0.34 0.48 ]
MakeNamedMaterial "ochre" "string type" "diffuse" "rgb reflectance" [ 0.72 0.47 0.15 ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.6 0.16 0.11 ]
MakeNamedMaterial "green" "string type" "diffuse" "rgb reflectance" [ 0.12 0.32 0.09 ]
MakeNamedMaterial "linen" "string type" "diffuse" "rgb reflectance" [ 0.74 0.68 0.57 ]
MakeNamedMaterial "net" "string type" "diffusetransmission"
    "rgb reflectance" [ 0.4 0.4 0.39 ] "rgb transmittance" [ 0.45 0.45 0.44 ]
MakeNamedMaterial "brass" "string type" "conductor" "spectrum eta" "metal-CuZn-eta"
    "spectrum k" "metal-CuZn-k" "float roughness" 0.03
MakeNamedMaterial "pane" "string type" "dielectric" "float eta" 1.5
)";

// The room: x from -2.6 to 2.6, y from 0 to 5.6, z from 0 to 2.7; its walls are 30 cm thick.
constexpr std::array<double, 2> kWindows = {1.35, 4.05};  // y of their middles, in the right wall
constexpr double kHalfWindow = 0.7;
constexpr double kSill = 0.3;
constexpr double kLintel = 2.3;

/// Local x along y, local y up, local z along x, from the inner face of the right wall.
Placement in_the_wall() {
    return {.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {2.6, 0, 0}};
}

Polygon window(double middle, double inset) {
    return rectangle(middle - kHalfWindow + inset, kSill + inset, middle + kHalfWindow - inset,
                     kLintel - inset);
}

/// A frame with two by three lights. @param middle  of the window.
Mesh window_frame(double middle) {
    constexpr double kBar = 0.022;
    std::vector<Polygon> lights;
    const double left = middle - kHalfWindow + 0.05;
    const double low = kSill + 0.05;
    const double wide = (2 * kHalfWindow - 0.1) / 2;
    const double high = (kLintel - kSill - 0.1) / 3;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            lights.push_back(rectangle(left + wide * i + kBar, low + high * j + kBar,
                                       left + wide * (i + 1) - kBar, low + high * (j + 1) - kBar));
    return placed(extrude(window(middle, -0.01), lights, 0.12, 0.17), in_the_wall());
}

void add_walls(SceneFolder& folder) {
    folder.add(
        "ground", "ground",
        placed(square_mesh(static_cast<float>(kRoomGroundHalfWidth), -0.25F), at({0.8, 2.8, 0})));
    folder.add("ceiling", "white", box_mesh({-2.95F, -0.35F, 2.7F}, {2.95F, 5.95F, 3}));
    folder.add("under the boards", "wood",
               box_mesh({-2.94F, -0.34F, -0.2F}, {2.94F, 5.94F, -0.02F}));
    folder.add("left wall", "plaster", box_mesh({-2.9F, -0.3F, -0.1F}, {-2.6F, 5.9F, 2.8F}));
    folder.add("back wall", "plaster", box_mesh({-2.8F, 5.6F, -0.11F}, {2.8F, 5.91F, 2.81F}));
    folder.add("front wall", "plaster", box_mesh({-2.8F, -0.31F, -0.11F}, {2.8F, 0, 2.81F}));
    folder.add("right wall", "plaster",
               placed(extrude(rectangle(-0.32, -0.12, 5.92, 2.82),
                              {window(kWindows[0], 0), window(kWindows[1], 0)}, 0, 0.3),
                      in_the_wall()));
    Mesh frames = window_frame(kWindows[0]);
    frames.append(window_frame(kWindows[1]));
    folder.add("frames", "white", frames);
    Mesh panes;
    for (const double middle : kWindows)
        panes.append(placed(extrude(window(middle, 0.045), {}, 0.143, 0.147), in_the_wall()));
    folder.add("panes", "pane", panes);
    Mesh trims = box_mesh({-2.61F, -0.05F, -0.05F}, {-2.585F, 5.65F, 0.1F});
    trims.append(box_mesh({-2.65F, 5.585F, -0.06F}, {2.65F, 5.61F, 0.101F}));
    folder.add("skirting", "white", trims);
}

/// Boards along the room with gaps of 3 mm, each row broken at another place.
Mesh floor_boards() {
    Mesh boards;
    constexpr int kRows = 32;
    for (int row = 0; row < kRows; ++row) {
        const double wide = 5.32 / kRows;
        const auto left = static_cast<float>(-2.66 + wide * row);
        const auto right = static_cast<float>(-2.66 + wide * (row + 1) - 0.003);
        const auto broken = static_cast<float>(0.6 + 0.37 * (row * 5 % 13));
        boards.append(box_mesh({left, -0.04F, -0.04F}, {right, broken, 0}));
        boards.append(box_mesh({left, broken + 0.003F, -0.04F}, {right, 5.64F, 0}));
    }
    return boards;
}

void add_seats(SceneFolder& folder) {
    const Seat large = sofa(3);
    const Placement by_the_wall = at({0.6, 5.5, 0});
    folder.add("sofa", "blue", placed(large.cloth, by_the_wall));
    const Seat small = sofa(1);
    const Placement in_the_corner = turned(0.2, {-2.35, 3.9, 0});
    folder.add("armchair", "linen", placed(small.cloth, in_the_corner));
    Mesh feet = placed(large.wood, by_the_wall);
    feet.append(placed(small.wood, in_the_corner));
    folder.add("feet", "wood", feet);
    const Mesh pillow = superellipsoid({0.22, 0.22, 0.075}, 0.55F, 75, 39);
    folder.add(
        "pillow", "ochre",
        placed(pillow, at({1.2, 5.05, 0.74}) * turned(-0.04, Vec3d(0)) * tilted(0.19, Vec3d(0))));
}

void add_pieces(SceneFolder& folder) {
    const Vec3d table(0.2, 3.9, 0.012);
    folder.add("rug", "red",
               placed(superellipsoid({1.15, 1.5, 0.012}, 0.2F, 96, 32), at({0.1, 3.7, 0.004})));
    folder.add("table", "wood", placed(round_table(), at(table)));
    folder.add("bowl", "white", placed(bowl(), at(table + Vec3d(0.12, 0.1, 0.441))));
    folder.add("fruit", "ochre", placed(fruit(), at(table + Vec3d(0.12, 0.1, 0.441))));
    folder.add("magazine", "blue",
               placed(box_mesh({-0.11F, -0.15F, 0.441F}, {0.11F, 0.15F, 0.453F}),
                      turned(0.08, table + Vec3d(-0.22, -0.18, 0))));
    const Placement shelf = at({-1.6, 5.58, 0});
    folder.add("shelves", "wood", placed(shelves(), shelf));
    constexpr std::array<std::string_view, 3> kCovers = {"red", "linen", "green"};
    for (int kind = 0; kind < 3; ++kind)
        folder.add("books-" + std::to_string(kind), kCovers.at(static_cast<std::size_t>(kind)),
                   placed(books(kind), shelf));
    folder.add("lamp", "brass", placed(lamp_stem(), at({-0.74, 5.2, 0})));
    folder.add("shade", "net", placed(lamp_shade(), at({-0.74, 5.2, 0})));
    folder.add("pot", "white", placed(pot(), at({2.1, 5.2, 0})));
    folder.add("leaves", "green", placed(leaves(), at({2.1, 5.2, 0})));
    const Placement hung = standing(0, {0.6, 5.59, 1.6});
    folder.add("picture-frame", "wood",
               placed(extrude(rectangle(-0.5, -0.36, 0.5, 0.36),
                              {rectangle(-0.46, -0.32, 0.46, 0.32)}, -0.02, 0.02),
                      hung));
    folder.add("canvas", "linen",
               placed(box_mesh({-0.48F, -0.34F, -0.015F}, {0.48F, 0.34F, 0.005F}), hung));
    folder.add("sun in the picture", "red",
               placed(extrude(ellipse(0.11, 0.11, 16), {}, 0, 0.007), hung * at({0.16, 0.08, 0})));
    folder.add("hills in the picture", "green",
               placed(extrude({{-0.455, -0.315, 0},
                               {0.455, -0.315, 0},
                               {0.455, -0.1, 0},
                               {0.2, -0.17, 0},
                               {-0.1, -0.04, 0},
                               {-0.3, -0.12, 0},
                               {-0.455, -0.02, 0}},
                              {}, 0, 0.009),
                      hung));
}

/// In front of the windows; the far one has a net, drawn.
void add_curtains(SceneFolder& folder) {
    const auto at_the_wall = [](double y) { return turned(0.25, {2.5, y, 0}); };
    folder.add("net", "net", placed(net_curtain(1.66, 2.44), at_the_wall(kWindows[1] - 0.83)));
    Mesh curtains;
    for (const double middle : kWindows)
        for (const double y : {middle - 1.1, middle + 0.72})
            curtains.append(placed(folded_curtain(0.38, 2.45), turned(0.25, {2.44, y, 0})));
    folder.add("curtains", "linen", curtains);
    Mesh rails;
    for (const double middle : kWindows)
        rails.append(placed(extrude(ellipse(0.014, 0.014, 24), {}, -1.2, 1.2),
                            standing(0, {2.47, middle, 2.47})));
    folder.add("rails", "brass", rails);
}

}  // namespace

std::vector<SceneFile> room_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    folder.text(kMaterials);
    add_walls(folder);
    folder.add("boards", "boards", floor_boards());
    add_seats(folder);
    add_pieces(folder);
    add_curtains(folder);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
