// The scene file around the snifter: camera, sun, table, and the media on each surface's sides.

#include "procedural/cognac.h"

#include "procedural/cognac_glass.h"
#include "procedural/scene_folder.h"

namespace sunfleck::engine {
namespace {

constexpr std::string_view kHead = R"(# Sunfleck, scene @NAME@: @WHAT@.
# Made by "sunfleck scene @NAME@". Dedicated to the public domain (CC0 1.0).
# Unit: centimetres; z is up; the first line makes the picture right-handed.
Scale -1 1 1
LookAt 0 -30 30  @TARGET@  0 0 1
Camera "perspective" "float fov" @FOV@
Film "rgb" "string filename" "@NAME@.exr" "integer xresolution" 256 "integer yresolution" 256
PixelFilter "box"
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 32

WorldBegin

# The sun, 50 degrees high, from behind on the left: perpendicular irradiance 4.
LightSource "distant" "point3 from" [ -0.35 0.54 0.766 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 1 1 ] "float scale" 4

# The table; its size rules how rarely a photon path is visible.
Material "diffuse" "rgb reflectance" [ 0.5 0.5 0.5 ]
)";

constexpr std::string_view kGlass = R"(
# The glass, index 1.5, where it meets air; the normal points to the air. The foot's edge stands
# 0.1 mm above the table.
Material "dielectric" "float eta" 1.5
Shape "plymesh" "string filename" "geometry/glass-air.ply"

# The brandy, index 1.36, where it meets the glass; the normal points to the glass, so that eta is
# 1.36 / 1.5. No air between them.
Material "dielectric" "float eta" 0.9066667
Shape "plymesh" "string filename" "geometry/brandy-glass.ply"

# The level of the brandy; the normal points to the air.
Material "dielectric" "float eta" 1.36
Shape "plymesh" "string filename" "geometry/brandy-air.ply"
)";

}  // namespace

std::vector<SceneFile> cognac_scene(const CloseUp& view, const Mesh& table) {
    std::string text = replaced(std::string(kHead), "@NAME@", view.name);
    text = replaced(text, "@WHAT@", view.what);
    text = replaced(text, "@TARGET@", view.target);
    text = replaced(text, "@FOV@", view.fov);
    text += shape_text(table);
    text += kGlass;
    const CognacGlass glass = cognac_glass();
    return {{std::string(view.name) + ".pbrt", text},
            {"geometry/glass-air.ply", ply_bytes(glass.glass_air)},
            {"geometry/brandy-glass.ply", ply_bytes(glass.liquid_glass)},
            {"geometry/brandy-air.ply", ply_bytes(glass.liquid_air)}};
}

}  // namespace sunfleck::engine
