// The room: walls with one hole, a pane in it, furniture of boxes, the ground outside, the sun; and
// in one of both scenes a lamp.

#include "procedural/window_room.h"

#include "procedural/scene_folder.h"

#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kHead =
    R"(# Sunfleck, scene @NAME@: the sun falls through one pane into a closed room@LAMP@.
# Made by "sunfleck scene @NAME@". Dedicated to the public domain (CC0 1.0).
# Unit: metres; z is up; the first line makes the picture right-handed.
Scale -1 1 1
LookAt -1.95 -1.6 1.65  0.35 0.75 0.85  0 0 1
Camera "perspective" "float fov" 64
Film "rgb" "string filename" "@NAME@.exr"
    "integer xresolution" 256 "integer yresolution" 256
PixelFilter "box"
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 32

WorldBegin

# The sun, about 40 degrees high: perpendicular irradiance 120. There is no sky.
LightSource "distant" "point3 from" [ 0.2 0.74 0.64 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.95 0.88 ] "float scale" 120

MakeNamedMaterial "ground" "string type" "diffuse" "rgb reflectance" [ 0.3 0.32 0.26 ]
MakeNamedMaterial "plaster" "string type" "diffuse" "rgb reflectance" [ 0.8 0.78 0.74 ]
MakeNamedMaterial "boards" "string type" "diffuse" "rgb reflectance" [ 0.5 0.4 0.3 ]
MakeNamedMaterial "wood" "string type" "diffuse" "rgb reflectance" [ 0.45 0.28 0.16 ]
MakeNamedMaterial "cloth" "string type" "diffuse" "rgb reflectance" [ 0.2 0.3 0.5 ]
MakeNamedMaterial "paper" "string type" "diffuse" "rgb reflectance" [ 0.65 0.25 0.2 ]
MakeNamedMaterial "pane" "string type" "dielectric" "float eta" 1.5
)";

constexpr std::string_view kLamp = R"(
# The lamp: a small ball below the ceiling, of 1/500 of the sun's power.
AttributeBegin
AreaLightSource "diffuse" "rgb L" [ 1 1 1 ] "float scale" 1500
Translate 0 0 2.2
Shape "sphere" "float radius" 0.05
AttributeEnd
)";

using Corner = std::array<float, 3>;

struct Box {
    Corner low;
    Corner high;
};

// Boxes sink into what they stand on, so that no two faces lie in one plane.
constexpr std::array<Box, 1> kFloorBoards = {{{{-2.55F, -2.05F, -0.05F}, {2.55F, 2.05F, 0.01F}}}};

constexpr std::array<Box, 10> kWood = {{
    // A table: its top and four legs.
    {{0.9F, -0.35F, 0.71F}, {2.1F, 0.45F, 0.75F}},
    {{0.95F, -0.3F, 0}, {1.02F, -0.23F, 0.72F}},
    {{1.98F, -0.3F, 0}, {2.05F, -0.23F, 0.72F}},
    {{0.95F, 0.33F, 0}, {1.02F, 0.4F, 0.72F}},
    {{1.98F, 0.33F, 0}, {2.05F, 0.4F, 0.72F}},
    // A shelf in the corner beyond: two sides and three boards.
    {{-1.5F, 1.72F, 0}, {-1.46F, 2.02F, 1.5F}},
    {{-0.64F, 1.72F, 0}, {-0.6F, 2.02F, 1.5F}},
    {{-1.47F, 1.73F, 0.4F}, {-0.63F, 2.02F, 0.43F}},
    {{-1.47F, 1.73F, 0.9F}, {-0.63F, 2.02F, 0.93F}},
    {{-1.47F, 1.73F, 1.4F}, {-0.63F, 2.02F, 1.43F}},
}};

constexpr std::array<Box, 2> kCloth = {{
    {{-0.8F, -0.05F, 0}, {-0.35F, 0.4F, 0.4F}},     // a stool at the edge of the sun
    {{-1.3F, 1.76F, 0.42F}, {-0.9F, 1.97F, 0.7F}},  // a basket on the shelf
}};

constexpr std::array<Box, 4> kPaper = {{
    {{-1.4F, 1.78F, 0.92F}, {-1.34F, 1.98F, 1.18F}},
    {{-1.33F, 1.78F, 0.92F}, {-1.28F, 1.98F, 1.14F}},
    {{-1.27F, 1.78F, 0.92F}, {-1.19F, 1.98F, 1.2F}},
    {{1.3F, -0.1F, 0.74F}, {1.6F, 0.12F, 0.79F}},  // a book on the table
}};

constexpr Box kInner = {{-2.5F, -2, 0}, {2.5F, 2, 2.7F}};
constexpr Box kOuter = {{-2.7F, -2.2F, -0.2F}, {2.7F, 2.2F, 2.9F}};
constexpr Box kHole = {{0.15F, 2, 1.3F}, {0.75F, 2.2F, 2}};  // in the wall towards +y
constexpr float kEmbedded = 0.01F;
constexpr float kHalfGround = 10;

template <std::size_t N>
std::string boxes_text(std::string_view material, const std::array<Box, N>& boxes) {
    std::string text = "\nNamedMaterial \"";
    text.append(material).append("\"\n");
    for (const Box& box : boxes) text += shape_text(box_mesh(box.low, box.high));
    return text;
}

/// Four points around the hole at one depth of the wall, counter-clockwise seen from -y.
void append_hole(Mesh& mesh, float y) {
    mesh.points.push_back({kHole.low[0], y, kHole.low[2]});
    mesh.points.push_back({kHole.high[0], y, kHole.low[2]});
    mesh.points.push_back({kHole.high[0], y, kHole.high[2]});
    mesh.points.push_back({kHole.low[0], y, kHole.high[2]});
}

}  // namespace

Mesh room_walls() {
    Mesh walls;
    // Corners of the box of 8: bit 0 is x, bit 1 is y, bit 2 is z; the inner ones are 8 to 15.
    for (const Box& box : {kOuter, kInner})
        for (const auto& point : box_mesh(box.low, box.high).points) walls.points.push_back(point);
    append_hole(walls, kHole.high[1]);  // 16 to 19
    append_hole(walls, kHole.low[1]);   // 20 to 23
    // All sides but the one with the window, the outer ones facing out, the inner ones in.
    walls.add_quad(0, 2, 3, 1);
    walls.add_quad(4, 5, 7, 6);
    walls.add_quad(0, 1, 5, 4);
    walls.add_quad(0, 4, 6, 2);
    walls.add_quad(1, 3, 7, 5);
    walls.add_quad(8, 9, 11, 10);
    walls.add_quad(12, 14, 15, 13);
    walls.add_quad(8, 12, 13, 9);
    walls.add_quad(8, 10, 14, 12);
    walls.add_quad(9, 13, 15, 11);
    // The window's wall is a frame of four trapezoids outside, the same inside, and the reveal.
    constexpr std::array<std::uint32_t, 4> kAround = {2, 3, 7, 6};
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        walls.add_quad(kAround.at(j), kAround.at(i), 16 + i, 16 + j);
        walls.add_quad(8 + kAround.at(i), 8 + kAround.at(j), 20 + j, 20 + i);
        walls.add_quad(20 + i, 20 + j, 16 + j, 16 + i);
    }
    return walls;
}

Mesh window_pane() {
    return box_mesh({kHole.low[0] - kEmbedded, 2.097F, kHole.low[2] - kEmbedded},
                    {kHole.high[0] + kEmbedded, 2.103F, kHole.high[2] + kEmbedded});
}

std::vector<SceneFile> window_room_scene(const ProceduralScene& scene) {
    const bool has_lamp = scene.name == "window-room-lamp";
    std::string text = replaced(std::string(kHead), "@NAME@", scene.name);
    text = replaced(text, "@LAMP@", has_lamp ? " with a lamp" : "");
    text +=
        "\n# Outside.\nNamedMaterial \"ground\"\n" + shape_text(square_mesh(kHalfGround, -0.1F));
    text += "\n# Walls, floor and ceiling, 20 cm thick, with a hole.\nNamedMaterial \"plaster\"\n" +
            shape_text(room_walls());
    text += "\n# The pane, 6 mm thick, its edges within the wall.\nNamedMaterial \"pane\"\n" +
            shape_text(window_pane());
    text += boxes_text("boards", kFloorBoards);
    text += boxes_text("wood", kWood);
    text += boxes_text("cloth", kCloth);
    text += boxes_text("paper", kPaper);
    if (has_lamp) text += kLamp;
    return {{scene.name + ".pbrt", text}};
}

}  // namespace sunfleck::engine
