// Desk, lamp, page, reading glass, mirror, and a ball of glass.

#include "procedural/magnifier.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/scene_random.h"
#include "procedural/surfaces.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: centimetres; z is up",
                             R"(LookAt -2 -38 27  -0.5 1.5 5.6  0 0 1
Camera "perspective" "float fov" 40
)",
                             640, 480, 40};

constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "desk" "string type" "diffuse" "rgb reflectance" [ 0.36 0.2 0.11 ]
MakeNamedMaterial "wall" "string type" "diffuse" "rgb reflectance" [ 0.48 0.53 0.5 ]
MakeNamedMaterial "paper" "string type" "diffuse" "rgb reflectance" [ 0.8 0.77 0.7 ]
MakeNamedMaterial "ink" "string type" "diffuse" "rgb reflectance" [ 0.04 0.04 0.05 ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.55 0.07 0.05 ]
MakeNamedMaterial "brass" "string type" "conductor" "spectrum eta" "metal-CuZn-eta"
    "spectrum k" "metal-CuZn-k" "float roughness" 0.02
MakeNamedMaterial "mirror" "string type" "conductor" "spectrum eta" "metal-Ag-eta"
    "spectrum k" "metal-Ag-k"
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.5
)";

constexpr Vec3d kLamp(11, 6, 0);        // its foot
constexpr double kGlobe = 14;           // height of the globe's middle
constexpr Vec3d kReading(-4, -2.5, 0);  // the middle of the page
constexpr double kLensHeight = 4.6;

Mesh ball(double radius, std::size_t around, std::size_t rings) {
    return ball_grid(around, rings,
                     [=](double u, double v) { return sphere_point(u, v) * radius; });
}

/// A globe with a wall of 3 mm, open towards the socket below, its rim within the socket.
Mesh globe() {
    constexpr int kSteps = 48;
    constexpr double kRim = 0.13;  // of the way from the lowest point to the highest
    const auto point = [](double radius, int step) {
        const Vec3d p = sphere_point(0, kRim + (1 - kRim) * step / kSteps) * radius;
        return ProfilePoint{step == kSteps ? 0 : p.x, p.z};
    };
    Profile outside;
    for (int i = 0; i <= kSteps; ++i) outside.push_back(point(5.3, i));
    Profile inside;
    for (int i = kSteps; i >= 0; --i) inside.push_back(point(5, i));
    inside.push_back(outside.front());
    Mesh globe = revolve(outside, 128);
    globe.append(revolve(inside, 128));
    return placed(globe, at(kLamp + Vec3d(0, 0, kGlobe)));
}

Mesh lamp_stand() {
    Profile profile = {{0, 0.02}, {4.6, 0.02}, {4.6, 0.4}};
    append_bezier(profile, {{{3, 1.2}, {0.6, 0.8}, {0.55, 2.2}}}, 12);
    append_bezier(profile, {{{0.5, 4}, {0.5, 6}, {0.6, 7.4}}}, 6);
    append_bezier(profile, {{{1, 8.2}, {2.4, 8.2}, {2.5, 8.9}}}, 8);
    profile.push_back({2.5, 9.9});
    profile.push_back({1.9, 10});
    profile.push_back({1.7, 9.6});
    profile.push_back({0.5, 9.6});
    profile.push_back({0.5, kGlobe - 1.2});
    profile.push_back({0, kGlobe - 1.2});
    return placed(revolve(profile, 96), at(kLamp));
}

/// Convex on both sides, 4.4 cm in radius, its rim held by the ring.
Mesh lens() {
    constexpr double kRadius = 4.4;
    Profile profile;
    for (int i = 0; i <= 20; ++i) {
        const double r = i / 20.0;
        profile.push_back({kRadius * r, -0.15 - 0.6 * (1 - r * r)});
    }
    for (int i = 20; i >= 0; --i) {
        const double r = i / 20.0;
        profile.push_back({kRadius * r, 0.15 + 0.6 * (1 - r * r)});
    }
    return revolve(profile, 128);
}

Placement lens_place() {
    return turned(-0.05, kReading + Vec3d(0, 0, kLensHeight)) * tilted(0.065, Vec3d(0));
}

/// Ring, handle and three feet.
Mesh holder() {
    const Profile section = {{4.3, -0.4}, {4.8, -0.4}, {4.8, 0.4}, {4.3, 0.4}, {4.3, -0.4}};
    Mesh holder = placed(revolve(section, 128), lens_place());
    for (const double turns : {0.03, 0.47, 0.75}) {
        const SinCos t = sin_cos_2pi(turns);
        const Vec3d top = lens_place()(Vec3d(t.cos, t.sin, 0) * 4.55);
        holder.append(
            placed(extrude(ellipse(0.2, 0.2, 24), {}, 0.061, top.z), at({top.x, top.y, 0})));
    }
    return holder;
}

/// A word's letters as bars, low and tall.
void append_word(Mesh& words, const Vec3d& start, double length, SceneRandom& random) {
    for (double letter = 0; letter + 0.1 < length; letter += 0.17) {
        const double height = random() < 0.25 ? 0.42 : 0.28;
        words.append(box_mesh(rounded_point({start.x + letter, start.y, start.z}),
                              rounded_point({start.x + letter + 0.11, start.y + height, 0.072})));
    }
}

/// Lines of words: bars of the width of words, their lengths by a small rule.
Mesh print() {
    Mesh words;
    SceneRandom random(7);
    for (int line = 0; line < 17; ++line) {
        const double y = 6.6 - 0.8 * line;
        for (double x = -5.2; x < 5;) {
            double length = 0.35 + 1.1 * random();
            if (x + length > 5.2) length = 5.2 - x;
            if (line % 6 == 5 && x > -1) break;  // the end of a paragraph
            append_word(words, {x, y, 0.05}, length, random);
            x += length + 0.25;
        }
    }
    return words;
}

void add_page(SceneFolder& folder) {
    const Placement lying = turned(-0.03, kReading);
    folder.add("page", "paper",
               placed(box_mesh({-6.6F, -8.4F, 0.01F}, {6.6F, 8.6F, 0.06F}), lying));
    folder.add("print", "ink", placed(print(), lying));
    folder.add("book", "red",
               placed(box_mesh({-5, -3.5F, 0.012F}, {5, 3.5F, 2.2F}), turned(0.09, {-17, 8, 0})));
    folder.add(
        "its pages", "paper",
        placed(box_mesh({-4.8F, -3.56F, 0.25F}, {5.05F, 3.3F, 1.95F}), turned(0.09, {-17, 8, 0})));
}

/// A round mirror in a frame, leaning on the wall.
void add_mirror(SceneFolder& folder) {
    const Placement leaning = at({-2.5, 14.2, 9.3}) * tilted(0.235, Vec3d(0));
    folder.add("mirror", "mirror", placed(extrude(ellipse(8.2, 8.2, 96), {}, -0.1, 0.1), leaning));
    Mesh frame = torus(8.4, 0.55, 128, 32);
    folder.add("frame", "brass", placed(frame, leaning));
}

void add_room(SceneFolder& folder) {
    folder.add("desk", "desk", box_mesh({-46, -22, -3}, {46, 17.5F, 0}));
    folder.add("floor", "desk", box_mesh({-92, -92, -70}, {92, 20, -65}));
    folder.add("ceiling", "wall", box_mesh({-93, -93, 100}, {93, 21, 105}));
    folder.add("back wall", "wall", box_mesh({-91, 17, -69}, {91, 19, 104}));
    folder.add("front wall", "wall", box_mesh({-91, -90, -69}, {91, -85, 104}));
    folder.add("left wall", "wall", box_mesh({-90, -89, -68}, {-85, 18, 103}));
    folder.add("right wall", "wall", box_mesh({85, -89, -68}, {90, 18, 103}));
}

}  // namespace

std::vector<SceneFile> magnifier_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    folder.text(kMaterials);
    folder.text(
        "\nAttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ 1 0.84 0.6 ] \"float scale\" "
        "900");
    folder.add("glow", "wall", placed(ball(kGlowRadius, 6, 4), at(kLamp + Vec3d(0, 0, kGlobe))));
    folder.text("AttributeEnd\n");
    add_room(folder);
    folder.add("globe", "glass", globe());
    folder.add("stand", "brass", lamp_stand());
    folder.add("lens", "glass", placed(lens(), lens_place()));
    folder.add("holder", "brass", holder());
    folder.add("paperweight", "glass", placed(ball(2.3, 96, 64), at({7.5, -7, 2.31})));
    add_page(folder);
    add_mirror(folder);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
