// The knot, its pedestal, and three lamps in a studio.

#include "procedural/statue.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

namespace sunfleck::engine {
namespace {

constexpr std::string_view kFar = R"(LookAt -47 -196 120  0 0 92  0 0 1
Camera "perspective" "float fov" 36
)";
constexpr std::string_view kNear = R"(LookAt -47 -196 120  -9 0 124  0 0 1
Camera "perspective" "float fov" @FOV@
)";

constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "bronze" "string type" "conductor" "spectrum eta" "metal-CuZn-eta"
    "spectrum k" "metal-CuZn-k" "float roughness" 0.01
MakeNamedMaterial "marble" "string type" "diffuse" "rgb reflectance" [ 0.62 0.6 0.56 ]
MakeNamedMaterial "floor" "string type" "diffuse" "rgb reflectance" [ 0.3 0.29 0.28 ]
MakeNamedMaterial "wall" "string type" "diffuse" "rgb reflectance" [ 0.34 0.36 0.4 ]
)";

struct Lamp {
    Vec3d place;
    std::string_view colour;
    double half;  // of its side, cm
};

constexpr std::array<Lamp, 3> kLamps = {{
    {{130, -130, 230}, "[ 1 0.9 0.75 ] \"float scale\" 190", 12},
    {{-170, -40, 190}, "[ 0.7 0.82 1 ] \"float scale\" 90", 12},
    {{60, 150, 220}, "[ 1 0.95 0.9 ] \"float scale\" 160", 9},
}};
constexpr Vec3d kMiddle(0, 0, 111.8);  // of the knot

/// A square that faces the statue.
Mesh panel(const Lamp& lamp) {
    const Vec3d way = (kMiddle - lamp.place).normalized();
    const Vec3d side = Vec3d(0, 0, 1).cross(way).normalized();
    const Placement facing = {.x = side, .y = way.cross(side), .z = way, .origin = lamp.place};
    return placed(square_mesh(static_cast<float>(lamp.half), 0), facing);
}

Mesh pedestal() {
    Profile profile = {{0, -1}, {30, -1}, {30, 6}};
    append_bezier(profile, {{{30, 8}, {27, 7}, {26, 10}}}, 6);
    append_bezier(profile, {{{23, 14}, {22, 12}, {21.5, 16}}}, 6);
    profile.push_back({20, 62});
    append_bezier(profile, {{{20, 68}, {25, 66}, {25, 70}}}, 6);
    profile.push_back({25, 76});
    profile.push_back({24.5, 76.5});
    profile.push_back({0, 76.5});
    return revolve(profile, 160);
}

/// Walls, floor and ceiling of the studio as boxes within one another.
void add_studio(SceneFolder& folder) {
    const auto half = static_cast<float>(kStudioHalfWidth);
    folder.add("floor", "floor",
               box_mesh({-half - 20, -half - 20, -10}, {half + 20, half + 20, 0}));
    folder.add("ceiling", "wall",
               box_mesh({-half - 21, -half - 21, 320}, {half + 21, half + 21, 330}));
    folder.add("left wall", "wall", box_mesh({-half - 10, -half - 9, -5}, {-half, half + 9, 325}));
    folder.add("right wall", "wall", box_mesh({half, -half - 8, -6}, {half + 10, half + 8, 326}));
    folder.add("back wall", "wall", box_mesh({-half - 5, half, -7}, {half + 5, half + 10, 327}));
    folder.add("front wall", "wall", box_mesh({-half - 4, -half - 10, -4}, {half + 4, -half, 324}));
}

}  // namespace

Mesh fluted_knot(std::size_t along, std::size_t around) {
    constexpr double kRing = 21;  // of the torus that the knot lies on
    constexpr double kTube = 9.5;
    constexpr double kThick = 5.8;  // of the fluted tube
    constexpr int kFlutes = 5;
    constexpr int kTwists = 8;
    return ring_grid(along, around, [=](double t, double turn) {
        const SinCos two = sin_cos_2pi(2 * t);
        const SinCos three = sin_cos_2pi(3 * t);
        const double r = kRing + kTube * three.cos;
        const Vec3d out(three.cos * two.cos, three.cos * two.sin, three.sin);
        const Vec3d middle(r * two.cos, r * two.sin, kTube * three.sin);
        const Vec3d way =
            Vec3d(-3 * kTube * three.sin * two.cos - 2 * r * two.sin,
                  -3 * kTube * three.sin * two.sin + 2 * r * two.cos, 3 * kTube * three.cos)
                .normalized();
        const SinCos flute = sin_cos_2pi(kFlutes * turn + kTwists * t);
        const SinCos a = sin_cos_2pi(turn);
        const double thick = kThick * (1 + 0.17 * flute.cos);
        return middle + (out * a.cos + out.cross(way) * a.sin) * thick;
    });
}

std::vector<SceneFile> statue_scene(const ProceduralScene& scene) {
    const bool near = scene.name.ends_with("near");
    const std::string camera = replaced(std::string(near ? kNear : kFar), "@FOV@",
                                        std::to_string(static_cast<int>(kNearFieldOfView)));
    SceneFolder folder(scene, {"Unit: centimetres; z is up", camera, 512, 512, 16});
    folder.text(kMaterials);
    for (const Lamp& lamp : kLamps) {
        folder.text(
            "\nAttributeBegin\nNamedMaterial \"wall\"\nAreaLightSource \"diffuse\" \"rgb L\" " +
            std::string(lamp.colour) + "\n" + shape_text(panel(lamp)) + "AttributeEnd\n");
    }
    add_studio(folder);
    folder.add("pedestal", "marble", pedestal());
    folder.add("knot", "bronze",
               placed(fluted_knot(1160, 160),
                      turned(0.03, kMiddle) * tilted(0.25, Vec3d(0)) * turned(0.0835, Vec3d(0))));
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
