// Walls from a scene text; the floor is a grid with hills of several sizes.
#include "room.h"

#include "import/pbrt/reader.h"

#include <fmt/format.h>

#include <cmath>

namespace sunfleck::engine::bench {
namespace {

constexpr const char* kWalls = R"(
Camera "perspective" "float fov" 70
WorldBegin
Material "diffuse" "rgb reflectance" [0.7 0.7 0.7]
Shape "trianglemesh"
  "point3 P" [-1 -1 -0.4  1 -1 -0.4  1 1 -0.4  -1 1 -0.4  -1 -1 1  1 -1 1  1 1 1  -1 1 1]
  "integer indices" [0 1 2 0 2 3  4 6 5 4 7 6  0 4 5 0 5 1  3 2 6 3 6 7  0 3 7 0 7 4  1 5 6 1 6 2]
AttributeBegin
AreaLightSource "diffuse" "rgb L" [10 10 10]
Shape "trianglemesh" "point3 P" [-0.3 -0.3 0.99  0.3 -0.3 0.99  0.3 0.3 0.99  -0.3 0.3 0.99]
  "integer indices" [0 2 1 0 3 2]
AttributeEnd
)";

/// Hills from the size of the room down to a fiftieth of it, always above the lowest wall.
float height(float x, float y) {
    float sum = 0;
    float size = 0.12F;
    float turns = 3;
    for (int octave = 0; octave < 5; ++octave) {
        sum += size * std::sin(turns * x + 1.3F * turns) * std::cos(turns * y + 0.7F * turns);
        size *= 0.5F;
        turns *= 2;
    }
    return sum;
}

TriangleMesh bumpy_floor(std::size_t triangles) {
    const auto side = static_cast<std::uint32_t>(
        std::max(1.0, std::round(std::sqrt(static_cast<double>(triangles) / 2))));
    TriangleMesh mesh;
    for (std::uint32_t j = 0; j <= side; ++j)
        for (std::uint32_t i = 0; i <= side; ++i) {
            const float x = 2.2F * static_cast<float>(i) / static_cast<float>(side) - 1.1F;
            const float y = 2.2F * static_cast<float>(j) / static_cast<float>(side) - 1.1F;
            mesh.positions.emplace_back(x, y, height(x, y));
        }
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t a = j * (side + 1) + i;
            const std::uint32_t b = a + side + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
    return mesh;
}

}  // namespace

SceneDescription bumpy_room(const RoomSettings& settings) {
    const std::string film = fmt::format(
        "LookAt -0.9 -0.9 0.6  0.2 0.2 0  0 0 1\n"
        "Film \"rgb\" \"integer xresolution\" {} \"integer yresolution\" {}\n",
        settings.resolution.x, settings.resolution.y);
    SceneDescription scene = read_pbrt_text(film + kWalls, "room.pbrt");
    ShapeDescription floor;
    floor.placed.shape = bumpy_floor(settings.triangles);
    floor.material = scene.shapes.front().material;
    scene.shapes.push_back(std::move(floor));
    return scene;
}

}  // namespace sunfleck::engine::bench
