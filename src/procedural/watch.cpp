// The scene file around the watch: camera with a lens, sun and sky, materials.

#include "procedural/watch.h"

#include "procedural/placement.h"
#include "procedural/scene_folder.h"
#include "procedural/watch_parts.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: millimetres; z is up",
                             R"(LookAt -8 -112 86  -3 -3 16.5  0 0 1
Camera "perspective" "float fov" 39 "float lensradius" 1.6 "float focaldistance" 132
)",
                             512, 512, 32};

constexpr std::string_view kMaterials = R"(
# The sun, 44 degrees high, from the front on the right: perpendicular irradiance 3.2; and a sky of
# one colour all around.
LightSource "distant" "point3 from" [ 0.62 -0.4 0.72 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.94 0.85 ] "float scale" 3.2
LightSource "infinite" "rgb L" [ 0.24 0.3 0.4 ]

MakeNamedMaterial "table" "string type" "diffuse" "rgb reflectance" [ 0.27 0.17 0.1 ]
MakeNamedMaterial "polished" "string type" "conductor" "spectrum eta" "metal-Au-eta"
    "spectrum k" "metal-Au-k"
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta"
    "spectrum k" "metal-Au-k" "float roughness" 0.004
MakeNamedMaterial "enamel" "string type" "diffuse" "rgb reflectance" [ 0.82 0.8 0.74 ]
MakeNamedMaterial "ink" "string type" "diffuse" "rgb reflectance" [ 0.03 0.03 0.035 ]
MakeNamedMaterial "blued" "string type" "diffuse" "rgb reflectance" [ 0.03 0.06 0.22 ]
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.52
)";

constexpr double kTurn = -0.125;  // of the watch on the table

}  // namespace

std::vector<SceneFile> watch_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    folder.text(kMaterials);
    folder.add("table", "table", square_mesh(static_cast<float>(kWatchTableHalfWidth), 0));
    const auto add = [&](const std::string& part, std::string_view material, const Mesh& mesh) {
        folder.add(part, material, placed(mesh, turned(kTurn, Vec3d(0))));
    };
    add("case", "gold", watch_case());
    add("fittings", "gold", watch_fittings());
    add("chain", "gold", watch_chain());
    add("lid", "polished", watch_lid());
    add("dial", "enamel", watch_dial());
    add("marks", "ink", watch_marks());
    add("hands", "blued", watch_hands());
    add("cover", "glass", watch_cover());
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
