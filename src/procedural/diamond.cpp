// The stone turned onto its side, and the scene file around it.

#include "procedural/diamond.h"

#include "procedural/brilliant.h"
#include "procedural/sky.h"

#include <cmath>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr double kRadius = 3.25;  // of the girdle: a stone of one carat
constexpr double kClear = 0.01;   // between the stone and the table

constexpr std::string_view kHead =
    R"(# Sunfleck, scene diamond: a brilliant in the sun, and the colours that it throws.
# Made by "sunfleck scene diamond". Dedicated to the public domain (CC0 1.0).
# Unit: millimetres; z is up; the first line makes the picture right-handed.
Scale -1 1 1
LookAt 7 -24 22  0.8 -1.2 0.6  0 0 1
Camera "perspective" "float fov" 27
Film "rgb" "string filename" "diamond.exr"
    "integer xresolution" 384 "integer yresolution" 256
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 40

WorldBegin

# The sun, 40 degrees high, from behind on the right: perpendicular irradiance 8; and its sky.
LightSource "distant" "point3 from" [ 0.45 0.62 0.643 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.97 0.92 ] "float scale" 8
LightSource "infinite" "string filename" "geometry/sky.pfm" "float scale" 0.8

# The table.
Material "diffuse" "rgb reflectance" [ 0.16 0.16 0.17 ]
)";

// n^2 = 1 + 0.3306 l^2 / (l^2 - 0.1750^2) + 4.3356 l^2 / (l^2 - 0.1060^2), l in micrometres: Peter,
// Ueber Brechungsindizes und Absorptionskonstanten des Diamanten (1923).
constexpr std::string_view kDiamond = R"(
# Diamond: index of refraction by wavelength (Peter 1923).
Material "dielectric" "spectrum eta" [
@TABLE@ ]
Shape "plymesh" "string filename" "geometry/brilliant.ply"
)";

/// Pairs of wavelength and index, five to a line.
std::string index_table() {
    std::string table;
    for (int wavelength = 360; wavelength <= 830; wavelength += 10) {
        const double square = 1e-6 * wavelength * wavelength;
        const double index = std::sqrt(1 + 0.3306 * square / (square - 0.1750 * 0.1750) +
                                       4.3356 * square / (square - 0.1060 * 0.1060));
        const auto digits = static_cast<int>(std::floor(index * 100000 + 0.5));  // 2.xxxxx
        const std::string text = std::to_string(digits);
        table += wavelength % 50 == 10 ? "    " : "  ";
        table += std::to_string(wavelength) + ' ' + text.substr(0, 1) + '.' + text.substr(1);
        if (wavelength % 50 == 0) table += '\n';
    }
    return table;
}

}  // namespace

Mesh lying_brilliant() {
    const BrilliantCut cut;
    Mesh mesh = brilliant(cut);
    // The line from the culet to the girdle's first corner is laid down along x.
    const double cosine = 1 / std::sqrt(1 + cut.pavilion_tangent * cut.pavilion_tangent);
    const double sine = cut.pavilion_tangent * cosine;
    for (auto& p : mesh.points) {
        const double x = p[0];
        const double z = p[2] + cut.pavilion_tangent;
        p = {static_cast<float>(kRadius * (x * cosine + z * sine - 0.5)),
             static_cast<float>(kRadius * p[1]),
             static_cast<float>(kRadius * (z * cosine - x * sine) + kClear)};
    }
    return mesh;
}

std::vector<SceneFile> diamond_scene() {
    std::string diamond(kDiamond);
    diamond.replace(diamond.find("@TABLE@"), 7, index_table());
    return {{"diamond.pbrt", std::string(kHead) + shape_text(square_mesh(40, 0)) + diamond},
            {"geometry/brilliant.ply", ply_bytes(lying_brilliant())},
            {"geometry/sky.pfm", clear_sky_pfm(Vec3d(0.45, 0.62, 0.643).normalized(), 64)}};
}

}  // namespace sunfleck::engine
