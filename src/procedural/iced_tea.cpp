// The scene file around the tumbler: camera, sun, sky, table, and which surface parts which media.

#include "procedural/iced_tea.h"

#include "procedural/iced_tea_glass.h"
#include "procedural/sky.h"

#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kHead =
    R"(# Sunfleck, scene iced-tea: a tumbler of tea with ice under a clear sky.
# Made by "sunfleck scene iced-tea". Dedicated to the public domain (CC0 1.0).
# Unit: centimetres; z is up; the first line makes the picture right-handed.
Scale -1 1 1
LookAt -3 -31 24  1.7 -0.6 3.6  0 0 1
Camera "perspective" "float fov" 26
Film "rgb" "string filename" "iced-tea.exr"
    "integer xresolution" 320 "integer yresolution" 320
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 48

# What the tea takes of light a centimetre.
MakeNamedMedium "tea" "string type" "homogeneous"
    "rgb sigma_a" [ 0.05 0.19 0.62 ] "rgb sigma_s" [ 0 0 0 ]

WorldBegin

# The sun, 42 degrees high, from behind on the left: perpendicular irradiance 4; and its sky.
LightSource "distant" "point3 from" [ -0.52 0.53 0.67 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.96 0.9 ] "float scale" 4
LightSource "infinite" "string filename" "geometry/tea-sky.pfm" "float scale" 0.7

# The table, under a cloth of squares.
AttributeBegin
    Texture "cloth" "spectrum" "checkerboard"
        "string mapping" "planar" "vector3 v1" [ 0.4 0 0 ] "vector3 v2" [ 0 0.4 0 ]
        "rgb tex1" [ 0.75 0.75 0.72 ] "rgb tex2" [ 0.36 0.45 0.55 ]
    Material "diffuse" "texture reflectance" "cloth"
)";

constexpr std::string_view kGlass = R"(AttributeEnd

# Glass (1.52) and air; the normal points to the air.
Material "dielectric" "float eta" 1.52
Shape "plymesh" "string filename" "geometry/tumbler-air.ply"

# Tea (1.333) and glass: the ratio across, 1.333 / 1.52. No air between them.
AttributeBegin
    MediumInterface "tea" ""
    Material "dielectric" "float eta" 0.8769737
    Shape "plymesh" "string filename" "geometry/tea-glass.ply"
AttributeEnd

# The level of the tea.
AttributeBegin
    MediumInterface "tea" ""
    Material "dielectric" "float eta" 1.333
    Shape "plymesh" "string filename" "geometry/tea-air.ply"
AttributeEnd

# Ice (1.31) in the tea, 1.31 / 1.333, and above it.
AttributeBegin
    MediumInterface "" "tea"
    Material "dielectric" "float eta" 0.9827457
    Shape "plymesh" "string filename" "geometry/ice-tea.ply"
AttributeEnd
Material "dielectric" "float eta" 1.31
Shape "plymesh" "string filename" "geometry/ice-air.ply"
)";

}  // namespace

std::vector<SceneFile> iced_tea_scene() {
    const IcedTea tea = iced_tea();
    return {{"iced-tea.pbrt",
             std::string(kHead) + shape_text(square_mesh(40, 0)) + std::string(kGlass)},
            {"geometry/tumbler-air.ply", ply_bytes(tea.glass_air)},
            {"geometry/tea-glass.ply", ply_bytes(tea.tea_glass)},
            {"geometry/tea-air.ply", ply_bytes(tea.tea_air)},
            {"geometry/ice-tea.ply", ply_bytes(tea.ice_tea)},
            {"geometry/ice-air.ply", ply_bytes(tea.ice_air)},
            {"geometry/tea-sky.pfm", clear_sky_pfm(Vec3d(-0.52, 0.53, 0.67).normalized(), 64)}};
}

}  // namespace sunfleck::engine
