// The scene file around the snifter: camera with a lens, sun, sky, leaves, cloth.

#include "procedural/brandy.h"

#include "procedural/leaves.h"
#include "procedural/scene_folder.h"
#include "procedural/snifter.h"

#include <cmath>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kHead =
    R"(# Sunfleck, scene brandy: a glass of brandy in a gap of the shade of leaves.
# Made by "sunfleck scene brandy". Dedicated to the public domain (CC0 1.0).
# Unit: centimetres; z is up; the first line makes the picture right-handed.
Scale -1 1 1
LookAt -3 -38 25  -3.6 -2.4 5.2  0 0 1
Camera "perspective" "float fov" 27.5 "float lensradius" 0.5 "float focaldistance" 47
Film "rgb" "string filename" "brandy.exr"
    "integer xresolution" 560 "integer yresolution" 420
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 48

# The absorption of the brandy, per centimetre.
MakeNamedMedium "brandy" "string type" "homogeneous"
    "rgb sigma_a" [ 0.055 0.22 0.72 ] "rgb sigma_s" [ 0 0 0 ]

WorldBegin

# The sun of a late afternoon, 43 degrees high, from behind on the right: perpendicular irradiance
# 4; and a sky of one colour.
LightSource "distant" "point3 from" [ 0.748 0.664 0.92 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.78 0.5 ] "float scale" 4
LightSource "infinite" "rgb L" [ 0.1 0.15 0.24 ]

# The cloth: bands along the sun's way, 11 cm wide, every other one of narrow stripes.
AttributeBegin
    Texture "stripes" "spectrum" "checkerboard" "string mapping" "planar"
        "vector3 v1" [ -0.54327 0.612 0 ] "vector3 v2" [ 0 0 0 ] "float udelta" 4.5
        "rgb tex1" [ 0.07 0.13 0.25 ] "rgb tex2" [ 0.45 0.47 0.48 ]
    Texture "bands" "spectrum" "checkerboard" "string mapping" "planar"
        "vector3 v1" [ -0.06036 0.068 0 ] "vector3 v2" [ 0 0 0 ] "float udelta" 0.5
        "rgb tex1" [ 0.7 0.66 0.58 ] "texture tex2" "stripes"
    Material "diffuse" "texture reflectance" "bands"
)";

constexpr std::string_view kBody = R"(AttributeEnd

# Leaves, 50 to 90 cm towards the sun, with a gap for the glass and its caustic.
Material "diffusetransmission" "rgb reflectance" [ 0.1 0.16 0.05 ]
    "rgb transmittance" [ 0.05 0.1 0.02 ]
Shape "plymesh" "string filename" "geometry/canopy.ply"

# Glass and air; the normal points to the air. The glass does not part colours: its wall is thin,
# and what is seen through its foot would be noisy.
Material "dielectric" "float eta" @GLASS@
Shape "plymesh" "string filename" "geometry/snifter-air.ply"

# Brandy and glass: the ratio across, by wavelength. No air between them.
AttributeBegin
    MediumInterface "brandy" ""
    Material "dielectric" "spectrum eta" [
@RATIO@ ]
    Shape "plymesh" "string filename" "geometry/brandy-snifter.ply"
AttributeEnd

# The level of the brandy, by wavelength: it throws a bow of colours.
AttributeBegin
    MediumInterface "brandy" ""
    Material "dielectric" "spectrum eta" [
@BRANDY@ ]
    Shape "plymesh" "string filename" "geometry/brandy-level.ply"
AttributeEnd
)";

/// Returns pairs of wavelength and brandy's relative refractive index, five to a line.
std::string index_table(double other) {
    std::string table;
    for (int wavelength = 360; wavelength <= 830; wavelength += 10) {
        const double index = brandy_index(wavelength / 1000.0) / other;
        const auto digits = static_cast<int>(std::floor(index * 100000 + 0.5));
        const std::string fraction = std::to_string(100000 + digits % 100000).substr(1);
        table += wavelength % 50 == 10 ? "        " : "  ";
        table +=
            std::to_string(wavelength) + ' ' + std::to_string(digits / 100000) + '.' + fraction;
        if (wavelength % 50 == 0) table += '\n';
    }
    return table;
}

}  // namespace

std::vector<SceneFile> brandy_scene() {
    std::string body = replaced(std::string(kBody), "@GLASS@", "1.52");
    body = replaced(body, "@RATIO@", index_table(kSnifterIndex));
    body = replaced(body, "@BRANDY@", index_table(1));
    const FilledGlass glass = filled_glass(snifter_curves(), kSnifterSegments);
    const Mesh leaves =
        canopy({.sun = Vec3d(0.748, 0.664, 0.92).normalized(), .place = Vec3d(-3, -3, 3)});
    return {{"brandy.pbrt", std::string(kHead) + shape_text(square_mesh(70, 0)) + body},
            {"geometry/canopy.ply", ply_bytes(leaves)},
            {"geometry/snifter-air.ply", ply_bytes(glass.glass_air)},
            {"geometry/brandy-snifter.ply", ply_bytes(glass.liquid_glass)},
            {"geometry/brandy-level.ply", ply_bytes(glass.liquid_air)}};
}

}  // namespace sunfleck::engine
