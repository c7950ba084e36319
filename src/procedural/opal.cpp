// A lantern of tin with a front of opal glass, and things on a table in its glow.

#include "procedural/opal.h"

#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

namespace sunfleck::engine {
namespace {

constexpr SceneHead kOpalHead = {.unit = "Unit: centimetres; z is up",
                                 .camera = R"(LookAt 9 -46 25  -0.6 -1 7  0 0 1
Camera "perspective" "float fov" 30
)",
                                 .width = 512,
                                 .height = 512,
                                 .max_depth = 256};

constexpr std::string_view kOpalMaterials = R"(
MakeNamedMaterial "wood" "string type" "diffuse" "rgb reflectance" [ 0.7 0.55 0.4 ]
MakeNamedMaterial "wall" "string type" "diffuse" "rgb reflectance" [ 0.72 0.72 0.7 ]
MakeNamedMaterial "tin" "string type" "diffuse" "rgb reflectance" [ 0.2 0.2 0.21 ]
MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [ 0.85 0.85 0.83 ]
MakeNamedMaterial "clay" "string type" "diffuse" "rgb reflectance" [ 0.62 0.3 0.17 ]
MakeNamedMaterial "blue" "string type" "diffuse" "rgb reflectance" [ 0.25 0.42 0.7 ]
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.5

# Opal glass: small grains scatter blue light more than red. Per centimetre.
MakeNamedMedium "opal" "string type" "homogeneous"
    "rgb sigma_s" [ 4.9 5.4 6.1 ] "rgb sigma_a" [ 0.004 0.005 0.008 ] "float g" 0.1
)";

// In the frame of the lantern its centre is (0, 8.2, 9.8).
constexpr std::string_view kOpalLamp = R"(
# The lamp, in the lantern: a ball of 3 cm.
AttributeBegin
Translate -15.12 4.02 9.8
NamedMaterial "white"
AreaLightSource "diffuse" "rgb L" [ 1 0.93 0.82 ] "float scale" 21
Shape "sphere" "float radius" 1.5
AttributeEnd
)";

/// Returns the place of the lantern, which is made with its front towards -y: x from -7 to 7, y
/// from -1 to 12.5, z from 0 to 20. It is turned, so that the front looks to the right.
Placement lantern_place() {
    return turned(0.19, {-7.5, 1, 0});
}

void add_lantern(SceneFolder& folder) {
    Mesh tin = box_mesh({-7, -1, 0.01F}, {7, 12.5F, 1.2F});
    tin.append(box_mesh({-7.4F, -1.5F, 18.4F}, {7.4F, 12.9F, 19.6F}));
    tin.append(box_mesh({-7.01F, -0.99F, 0.5F}, {-5.8F, 12.3F, 19}));
    tin.append(box_mesh({5.8F, -0.99F, 0.5F}, {7.01F, 12.3F, 19}));
    tin.append(box_mesh({-6.5F, 11.6F, 0.6F}, {6.5F, 12.49F, 18.8F}));
    folder.add("opal-lantern", "tin", placed(tin, lantern_place()));
    Mesh lining = box_mesh({-5.9F, 0.2F, 1.1F}, {5.9F, 11.7F, 1.3F});
    lining.append(box_mesh({-5.91F, 0.21F, 18.3F}, {5.91F, 11.71F, 18.5F}));
    lining.append(box_mesh({-5.92F, 0.22F, 1.15F}, {-5.7F, 11.72F, 18.45F}));
    lining.append(box_mesh({5.7F, 0.22F, 1.15F}, {5.92F, 11.72F, 18.45F}));
    lining.append(box_mesh({-5.8F, 11.5F, 1.16F}, {5.8F, 11.73F, 18.44F}));
    folder.add("lining", "white", placed(lining, lantern_place()));
    folder.add("knob", "tin",
               placed(superellipsoid({1.1, 1.1, 0.9}, 0.8F, 40, 20),
                      lantern_place() * at({0, 5.7, 20.2})));
}

void add_opal_glass(SceneFolder& folder) {
    folder.text("\nAttributeBegin\nMediumInterface \"opal\" \"\"");
    folder.add("pane", "glass",
               placed(box_mesh({-6.2F, -0.6F, 0.9F}, {6.2F, 0.1F, 18.7F}), lantern_place()));
    folder.text(
        "\n# A ball of the same glass\nTranslate 1.4 -7.6 2.01\nShape \"sphere\" "
        "\"float radius\" 2\nAttributeEnd\n");
}

Mesh opal_jug() {
    Profile profile = {{0, 0.01}, {1.7, 0.01}};
    append_bezier(profile, {{{4.6, 2.6}, {3.6, 6.4}, {1.5, 8}}}, 24);
    append_bezier(profile, {{{1.2, 9}, {1.3, 9.8}, {2.1, 10.6}}}, 12);
    append_bezier(profile, {{{1.8, 10.4}, {1, 9}, {1.2, 8}}}, 12);
    append_bezier(profile, {{{3.2, 6.2}, {4, 2.8}, {0, 0.6}}}, 20);
    return revolve(profile, 72);
}

Mesh egg() {
    return ball_grid(64, 40, [](double azimuth, double height) {
        const Vec3d p = sphere_point(azimuth, height);
        const double waist = 1.95 * (1 - 0.13 * p.z);
        return Vec3d(p.x * waist, p.y * waist, 2.5 * p.z);
    });
}

}  // namespace

std::vector<SceneFile> opal_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kOpalHead);
    folder.text(kOpalMaterials);
    folder.add("table", "wood", box_mesh({-60, -70, -4}, {60, 15, 0}));
    folder.add("wall", "wall", box_mesh({-61, 14, -10}, {61, 17, 80}));
    folder.add("right wall", "wall", box_mesh({17, -69, -9}, {20, 14.5F, 79}));
    add_lantern(folder);
    add_opal_glass(folder);
    folder.text(kOpalLamp);
    folder.add("jug", "clay", placed(opal_jug(), at({5.2, 3, 0})));
    folder.add("egg", "white",
               placed(egg(), turned(0.16, {6.8, -6.6, 1.99}) * tilted(0.25, {0, 0, 0})));
    folder.add("cube", "blue",
               placed(box_mesh({-1.6F, -1.6F, 0.01F}, {1.6F, 1.6F, 3.2F}),
                      turned(0.09, {-3.2, -11.5, 0})));
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
