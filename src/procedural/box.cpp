// Nine meshes: room, two coloured walls, two mirrored balls, a glass ball, and two lamps, each made
// of a mirrored hollow with a lens as its only opening.

#include "procedural/box.h"

#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_folder.h"
#include "procedural/surfaces.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr SceneHead kHead = {"Unit: about half the width of the box; y is up",
                             R"(LookAt -0.24178 -0.133496 2.43055  0 -0.05 0.25  0 1 0
Camera "perspective" "float fov" 35
)",
                             512, 512, 10};

// Reflectances were sRGB 0.918, (0.098, 0.098, 0.949) and (0.949, 0.949, 0.098).
constexpr std::string_view kMaterials = R"(
MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [ 0.823 0.823 0.823 ]
MakeNamedMaterial "bright" "string type" "diffuse" "rgb reflectance" [ 1 1 1 ]
MakeNamedMaterial "blue" "string type" "diffuse" "rgb reflectance" [ 0.0098 0.0098 0.887 ]
MakeNamedMaterial "yellow" "string type" "diffuse" "rgb reflectance" [ 0.887 0.887 0.0098 ]
MakeNamedMaterial "mirror" "string type" "conductor" "rgb reflectance" [ 0.999 0.999 0.999 ]
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.5046
)";

constexpr std::string_view kLamp = R"(
AttributeBegin
NamedMaterial "white"
AreaLightSource "diffuse" "rgb L" [ 31250 31250 31250 ]
)";

struct Lamp {
    double x;
    double z;
};

constexpr std::array<Lamp, 2> kLamps = {{{0.32357, 0.4948}, {-0.34357, 0.4348}}};
constexpr double kFloor = -0.55;
constexpr double kBall = 0.2036;

/// From z up around the origin to y up around a point.
Mesh upright(const Mesh& mesh, const Vec3d& where) {
    return placed(mesh, tilted(-0.25, where));
}

Mesh quad(const std::array<Vec3d, 4>& corners) {
    Mesh mesh;
    add_polygon(mesh, {corners.begin(), corners.end()});
    return mesh;
}

Mesh ball(std::size_t around, std::size_t rings, double radius, const Vec3d& centre) {
    return placed(
        ball_grid(around, rings, [&](double u, double v) { return sphere_point(u, v) * radius; }),
        tilted(-0.25, centre));
}

Mesh smoothed(Mesh ball, const Vec3d& centre) {
    for (const auto& p : ball.points)
        ball.normals.push_back(rounded_point((Vec3d(p[0], p[1], p[2]) - centre).normalized()));
    return ball;
}

/// For each corner of a triangle a point of its own, so that readers keep it flat.
Mesh faceted(const Mesh& mesh) {
    Mesh flat;
    for (const auto& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(flat.points.size());
        for (const std::uint32_t index : t) flat.points.push_back(mesh.points[index]);
        flat.triangles.push_back({first, first + 1, first + 2});
    }
    return flat;
}

/// Floor, ceiling, back and sides as single sheets; a pole and a stand for the mirrored balls; the
/// housings of the lamps: 10 + 28 + 40 + 2 * 46 triangles.
Mesh room() {
    constexpr double kX = 0.851;
    constexpr double kTop = 0.617;
    Mesh room = quad({{{-kX, kFloor, 1}, {kX, kFloor, 1}, {kX, kFloor, -1}, {-kX, kFloor, -1}}});
    room.append(quad({{{-kX, kTop, -1}, {kX, kTop, -1}, {kX, kTop, 1}, {-kX, kTop, 1}}}));
    room.append(quad({{{-kX, kFloor, -1}, {kX, kFloor, -1}, {kX, kTop, -1}, {-kX, kTop, -1}}}));
    room.append(quad({{{-kX, kFloor, 1}, {-kX, kFloor, -1}, {-kX, kTop, -1}, {-kX, kTop, 1}}}));
    room.append(quad({{{kX, kFloor, -1}, {kX, kFloor, 1}, {kX, kTop, 1}, {kX, kTop, -1}}}));
    room.append(upright(extrude(ellipse(0.035, 0.035, 8), {}, kFloor - 0.01, -0.2395),
                        {0.4523, 0, 0.4429}));
    room.append(
        upright(extrude(ellipse(0.1, 0.1, 11), {}, kFloor - 0.01, -0.5396), {-0.0523, 0, 0.0819}));
    for (const Lamp& lamp : kLamps) {
        Mesh housing = revolve({{0.104, 0.44}, {0.104, 0.605}}, 16);
        housing.append(fill_ring({0.104, 0.605}, 16));
        room.append(upright(housing, {lamp.x, 0, lamp.z}));
    }
    return room;
}

/// Most of a sphere: 16 + 10 * 32 triangles, open below.
Mesh reflector(const Lamp& lamp) {
    constexpr double kRadius = 0.1;
    constexpr double kCentre = 0.4905;
    constexpr double kOpening = -0.0875;  // below the centre
    const double opening_radius = std::sqrt(kRadius * kRadius - kOpening * kOpening);
    Profile profile = {{opening_radius, kCentre + kOpening}};
    for (int i = 1; i <= 11; ++i) {
        const Vec3d p = sphere_point(0, 0.17 + 0.83 * i / 11);
        profile.push_back({i == 11 ? 0 : kRadius * p.x, kCentre + kRadius * p.z});
    }
    return upright(revolve(profile, 16), {lamp.x, 0, lamp.z});
}

/// Convex on both sides, its edge within the reflector: 16 * 20 triangles.
Mesh lens(const Lamp& lamp) {
    constexpr double kRadius = 0.0575;
    Profile profile;
    for (int i = 0; i <= 5; ++i) {
        const double r = 0.2 * i;
        profile.push_back({kRadius * r, 0.407 - 0.006 * (1 - r * r)});
    }
    for (int i = 5; i >= 0; --i) {
        const double r = 0.2 * i;
        profile.push_back({kRadius * r, 0.4075 + 0.0055 * (1 - r * r)});
    }
    return upright(revolve(profile, 16), {lamp.x, 0, lamp.z});
}

/// The source, 8 mm by 4 mm if the box were two metres high, facing down.
Mesh source(const Lamp& lamp) {
    constexpr double kY = 0.42;
    return quad({{{lamp.x - 0.004, kY, lamp.z - 0.002},
                  {lamp.x + 0.004, kY, lamp.z - 0.002},
                  {lamp.x + 0.004, kY, lamp.z + 0.002},
                  {lamp.x - 0.004, kY, lamp.z + 0.002}}});
}

void add_lamps(SceneFolder& folder) {
    Mesh reflectors = reflector(kLamps[0]);
    reflectors.append(reflector(kLamps[1]));
    Mesh lenses = lens(kLamps[0]);
    lenses.append(lens(kLamps[1]));
    Mesh discs;
    for (const Lamp& lamp : kLamps)
        discs.append(
            upright(extrude(ellipse(0.03, 0.03, 28), {}, 0.486, 0.496), {lamp.x, 0, lamp.z}));
    folder.add("reflectors", "mirror", reflectors);
    folder.add("lenses", "glass", lenses);
    folder.add("discs", "bright", discs);
    folder.text("\n# Two sources between reflector and lens, of flux 3.14 each.");
    for (const Lamp& lamp : kLamps) {
        folder.text(kLamp);
        folder.text(shape_text(source(lamp)) + "AttributeEnd\n");
    }
}

}  // namespace

std::vector<SceneFile> box_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kHead);
    folder.text(kMaterials);
    folder.add("room", "white", room());
    folder.add("right wall", "blue",
               quad({{{0.723, -0.562, -0.15},
                      {0.851, -0.562, 1},
                      {0.851, 0.595, 1},
                      {0.723, 0.595, -0.15}}}));
    folder.add("left wall", "yellow",
               quad({{{-0.851, -0.554, 0.824},
                      {-0.647, -0.554, -1},
                      {-0.647, 0.617, -1},
                      {-0.851, 0.617, 0.824}}}));
    constexpr Vec3d kFaceted(0.4523, -0.0394, 0.4429);
    constexpr Vec3d kSmooth(-0.0523, -0.336, 0.0819);
    folder.add("faceted-ball", "mirror", faceted(ball(24, 16, kBall, kFaceted)));
    folder.add("smooth-ball", "mirror", smoothed(ball(24, 16, kBall, kSmooth), kSmooth));
    folder.add("glass-ball", "glass", ball(16, 11, 0.0679, {-0.6407, -0.4813, 0.55}));
    add_lamps(folder);
    return std::move(folder).files();
}

}  // namespace sunfleck::engine
