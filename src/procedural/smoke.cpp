// A bowl of incense on a table in a dark room, and its smoke in a beam of light.

#include "procedural/smoke.h"

#include "procedural/density.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr SceneHead kSmokeHead = {.unit = "Unit: centimetres; z is up",
                                  .camera = R"(LookAt 2 -70 26  0 0 20.5  0 0 1
Camera "perspective" "float fov" 33
)",
                                  .width = 400,
                                  .height = 512,
                                  .max_depth = 24};

constexpr std::string_view kSmokeMaterials = R"(
# A narrow lamp at the right, above and a little behind.
LightSource "spot" "point3 from" [ 95 42 52 ] "point3 to" [ 0 0 17 ]
    "float coneangle" 13 "float conedeltaangle" 4 "rgb I" [ 1 0.94 0.85 ] "float scale" 90000
# And a weak blue one at the left.
LightSource "spot" "point3 from" [ -90 -30 40 ] "point3 to" [ 0 0 14 ]
    "float coneangle" 18 "float conedeltaangle" 8 "rgb I" [ 0.45 0.65 1 ] "float scale" 5000

MakeNamedMaterial "nothing" "string type" "interface"
MakeNamedMaterial "table" "string type" "diffuse" "rgb reflectance" [ 0.3 0.19 0.12 ]
MakeNamedMaterial "wall" "string type" "diffuse" "rgb reflectance" [ 0.1 0.1 0.11 ]
MakeNamedMaterial "bronze" "string type" "conductor" "spectrum eta" "metal-CuZn-eta"
    "spectrum k" "metal-CuZn-k" "float roughness" 0.25
MakeNamedMaterial "ash" "string type" "diffuse" "rgb reflectance" [ 0.3 0.29 0.28 ]

# Smoke: grains finer than a wavelength scatter blue light more. Per centimetre where it is
# densest.
MakeNamedMedium "smoke" "string type" "uniformgrid"
    "rgb sigma_s" [ 0.62 0.72 0.9 ] "rgb sigma_a" [ 0.03 0.03 0.03 ] "float g" 0.35
    "float scale" 0.01
)";

// The smoke: x and y from -9 to 9, z from 5.2 to 40.4: cells of 4.5 x 4.5 x 5.5 mm.
constexpr double kSmokeLow = 5.2;
constexpr double kSmokeHigh = 40.4;

/// Returns the density at a place: a thread that sways, then rolls and spreads with height.
double smoke_density(const Vec3d& place) {
    const double height = (place.z - kSmokeLow) / (kSmokeHigh - kSmokeLow);
    const double wild = smooth_step(0.12, 0.75, height);
    Vec3d p = place;
    p += smooth_noise_vector(place * 0.1, 11, 1) * (5 * wild);
    p += smooth_noise_vector(p * 0.22, 31, 2) * (2.6 * wild);
    const double sway = 1.5 * smooth_noise(Vec3d(0.5, 0.5, place.z * 0.12), 5);
    const double x = p.x - sway * smooth_step(0, 0.3, height);
    const double radius = 1.5 + 4.6 * height * height + 1.2 * height;
    const double distance2 = (x * x + p.y * p.y) / (radius * radius);
    if (distance2 >= 1) return 0;
    // Sheets: the noise is dense where it is near zero.
    const double sheet = 1 - std::min(1.0, 2.2 * std::abs(smooth_noise(p * 0.34, 71, 2)));
    const double body =
        (1 - distance2) * (1 - distance2) * (1 - wild + wild * (0.12 + 0.88 * sheet * sheet));
    const double thinner = 1 / (1 + 1.6 * height);
    return body * thinner * smooth_step(1, 0.6, height);
}

Mesh incense_bowl() {
    Profile profile = {{0, 0.01}, {3.2, 0.01}, {3.2, 0.35}};
    append_bezier(profile, {{{2.2, 0.5}, {2, 0.9}, {2.4, 1.1}}}, 10);
    append_bezier(profile, {{{5.2, 1.6}, {6.4, 3.2}, {6.6, 5.4}}}, 32);
    append_bezier(profile, {{{6.6, 5.6}, {6.3, 5.6}, {6.3, 5.4}}}, 8);
    append_bezier(profile, {{{6, 3.4}, {4.8, 2}, {0, 1.6}}}, 32);
    return revolve(profile, 96);
}

}  // namespace

std::vector<SceneFile> smoke_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kSmokeHead);
    std::string materials(kSmokeMaterials);
    materials +=
        density_text({{-9, -9, kSmokeLow}, {9, 9, kSmokeHigh}, {40, 40, 64}}, smoke_density);
    folder.text(materials);
    folder.add("table", "table", box_mesh({-60, -60, -4}, {60, 40, 0}));
    folder.add("wall", "wall", box_mesh({-140, 60, -40}, {140, 64, 120}));
    folder.add("incense-bowl", "bronze", incense_bowl());
    folder.add("incense", "ash",
               placed(superellipsoid({1.3, 1.3, 2.1}, 1, 40, 20), at({0, 0, 3.4})));
    folder.text("\nAttributeBegin\nMediumInterface \"smoke\" \"\"");
    folder.add(
        "border of the smoke", "nothing",
        box_mesh({-9, -9, static_cast<float>(kSmokeLow)}, {9, 9, static_cast<float>(kSmokeHigh)}));
    folder.text("AttributeEnd\n");
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
