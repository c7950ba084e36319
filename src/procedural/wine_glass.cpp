// The curves of the wine glass, and the scene file around it.

#include "procedural/wine_glass.h"

#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

/// Each piece begins in the direction in which the previous one ends.
constexpr std::array<CurvePiece, 9> kWall = {{
    {{{{0, 0.3}, {2, 0.3}, {2.9, 0.01}, {3.7, 0.01}}}, 10},         // the hollow underside
    {{{{3.7, 0.01}, {3.9, 0.01}, {4.02, 0.06}, {4.02, 0.13}}}, 8},  // the foot's edge
    {{{{4.02, 0.13}, {4.02, 0.2}, {3.95, 0.23}, {3.8, 0.25}}}, 8},
    {{{{3.8, 0.25}, {1.55, 0.55}, {0.38, 1}, {0.38, 4}}}, 24},
    {{{{0.38, 4}, {0.38, 6}, {0.38, 7.5}, {0.38, 9}}}, 4},        // the stem
    {{{{0.38, 9}, {0.38, 11.2}, {5.2, 10.6}, {5.2, 15.4}}}, 64},  // the bowl
    {{{{5.2, 15.4}, {5.2, 18.2}, {4.3, 20.6}, {4, 22.6}}}, 64},
    {{{{4, 22.6}, {3.988, 22.68}, {3.858, 22.68}, {3.87, 22.6}}}, 8},  // the rim
    {{{{3.87, 22.6}, {4.17, 20.6}, {5.06, 18.2}, {5.06, 15.4}}}, 64},  // the inside
}};

constexpr ProfileCurve kBottom = {{{5.06, 15.4}, {5.06, 12.2}, {2.4, 11}, {0, 11}}};

constexpr std::string_view kCamera = R"(LookAt 42 -22 50  @TARGET@  0 0 1
Camera "perspective" "float fov" @FOV@
)";

constexpr std::string_view kSurroundings = R"(
# The sun, 59 degrees high: perpendicular irradiance 3.
LightSource "distant" "point3 from" [ -3 -2 6 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 1 1 ] "float scale" 3

# The table.
Material "diffuse" "rgb reflectance" [ 0.6 0.6 0.6 ]
)";

constexpr std::string_view kGlass = R"(
# Glass, index 1.5, and air; the normal points to the air.
Material "dielectric" "float eta" 1.5
Shape "plymesh" "string filename" "geometry/wine-glass.ply"

# Wine, index 1.345, and glass; the normal points to the glass, so that eta is 1.345 / 1.5.
Material "dielectric" "float eta" 0.8966667
Shape "plymesh" "string filename" "geometry/wine-wall.ply"

# The level of the wine; the normal points to the air.
Material "dielectric" "float eta" 1.345
Shape "plymesh" "string filename" "geometry/wine-level.ply"
)";

}  // namespace

GlassCurves wine_glass_curves() {
    return {kWall, kBottom, 0.05};
}

std::vector<SceneFile> wine_glass_scene(const CloseUp& view, const Mesh& table) {
    std::string camera = replaced(std::string(kCamera), "@TARGET@", view.target);
    camera = replaced(camera, "@FOV@", view.fov);
    SceneFolder folder({std::string(view.name), std::string(view.what)},
                       {.unit = "Unit: centimetres; z is up",
                        .camera = camera,
                        .width = 256,
                        .height = 256,
                        .max_depth = 48});
    folder.text(kSurroundings);
    folder.text(shape_text(table));
    folder.text(kGlass);
    std::vector<SceneFile> files = std::move(folder).files();
    const FilledGlass glass = filled_glass(wine_glass_curves(), kWineGlassSegments);
    files.push_back({"geometry/wine-glass.ply", ply_bytes(glass.glass_air)});
    files.push_back({"geometry/wine-wall.ply", ply_bytes(glass.liquid_glass)});
    files.push_back({"geometry/wine-level.ply", ply_bytes(glass.liquid_air)});
    return files;
}

}  // namespace sunfleck::engine
