// Two tumblers in the sun: milk in one, water and a sinking drop of milk in the other.

#include "procedural/milk.h"

#include "procedural/density.h"
#include "procedural/placement.h"
#include "procedural/scene_folder.h"
#include "procedural/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr SceneHead kMilkHead = {.unit = "Unit: centimetres; z is up",
                                 .camera = R"(LookAt 4 -36 29  1 -1.4 3.8  0 0 1
Camera "perspective" "float fov" 27
)",
                                 .width = 512,
                                 .height = 400,
                                 .max_depth = 256};

/// Each piece begins in the direction in which the previous one ends.
constexpr std::array<CurvePiece, 4> kMilkWall = {{
    {{{{0, 0.3}, {1.6, 0.3}, {2.1, 0.01}, {2.6, 0.01}}}, 10},  // the hollow underside
    {{{{2.6, 0.01}, {3.1, 0.01}, {3.3, 0.25}, {3.34, 0.8}}}, 10},
    {{{{3.34, 0.8}, {3.44, 2.2}, {3.75, 8}, {3.75, 10.8}}}, 32},         // the outside
    {{{{3.75, 10.8}, {3.75, 10.94}, {3.53, 10.94}, {3.53, 10.8}}}, 10},  // the rim
}};

constexpr ProfileCurve kMilkBottom = {{{3.53, 10.8}, {3.53, 1.2}, {3.3, 1.1}, {0, 1.1}}};

constexpr std::array<double, 3> kMilkSun = {-0.62, 0.42, 0.66};
constexpr std::array<double, 2> kMilkMiddle = {5, 2.2};    // x and y of the glass of milk
constexpr std::array<double, 2> kWaterMiddle = {-4.2, 0};  // and of the glass of water

constexpr std::string_view kMilkMaterials = R"(
# The sun, 41 degrees high, from behind on the left: perpendicular irradiance 4; and its sky.
LightSource "distant" "point3 from" [ -0.62 0.42 0.66 ] "point3 to" [ 0 0 0 ]
    "rgb L" [ 1 0.96 0.9 ] "float scale" 4
LightSource "infinite" "string filename" "geometry/milk-sky.pfm" "float scale" 0.7

MakeNamedMaterial "cloth" "string type" "diffuse" "rgb reflectance" [ 0.34 0.42 0.5 ]
# Glass of index 1.52; water of 1.333, milk of 1.35. Where liquid meets glass, the normal points to
# the glass, and eta is the ratio of the two.
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.52
MakeNamedMaterial "water wall" "string type" "dielectric" "float eta" 0.8769737
MakeNamedMaterial "water level" "string type" "dielectric" "float eta" 1.333
MakeNamedMaterial "milk wall" "string type" "dielectric" "float eta" 0.8881579
MakeNamedMaterial "milk level" "string type" "dielectric" "float eta" 1.35

# Thin milk, per centimetre: a mean free path of 4 mm, and a little blue light absorbed. The
# scattering is that of real milk without its forward peak (g = 0), and weaker.
MakeNamedMedium "milk" "string type" "homogeneous"
    "rgb sigma_s" [ 2.5 2.6 2.7 ] "rgb sigma_a" [ 0.0008 0.002 0.012 ] "float g" 0

# The drop in the water: the same milk, thicker. The density is from 0 to 100.
MakeNamedMedium "drop" "string type" "uniformgrid"
    "rgb sigma_s" [ 4 4.2 4.4 ] "rgb sigma_a" [ 0.001 0.003 0.018 ] "float g" 0
    "float scale" 0.01
)";

/// Returns the density of the sinking drop in the frame of its glass: a ring that rolls as it
/// sinks, the thread that it hangs on, and the stain below the level that it came from.
double drop_density(const Vec3d& place) {
    const Vec3d p = place + smooth_noise_vector(place * 0.8, 3, 3) * 0.42;
    const double from_axis = std::sqrt(p.x * p.x + p.y * p.y);
    const auto ring = [&](double radius, double height, double thickness) {
        const double x = (from_axis - radius) / thickness;
        const double z = (p.z - height) / thickness;
        return std::max(0.0, 1 - x * x - z * z);
    };
    const double thread_radius = 0.2 + 0.05 * (p.z - 3);
    const double thread =
        std::max(0.0, 1 - from_axis * from_axis / (thread_radius * thread_radius)) *
        smooth_step(3, 3.6, p.z);
    const double stain = ring(0, 7.4, 1.0) * 0.8;
    return std::min(1.0, std::max({ring(1.05, 3.1, 0.55), thread, stain, ring(0.5, 5.4, 0.35)}));
}

/// Adds the three surfaces of a filled glass. @param drink  names its medium, parts and materials.
void add_glass(SceneFolder& folder, const std::string& drink, std::string_view medium,
               const std::array<double, 2>& middle) {
    const FilledGlass glass = filled_glass(milk_glass_curves(), kMilkGlassSegments);
    const Placement place = at({middle[0], middle[1], 0});
    folder.add(drink + "-tumbler", "glass", placed(glass.glass_air, place));
    folder.text(fmt::format("\nAttributeBegin\nMediumInterface \"{}\" \"\"", medium));
    folder.add(drink + "-tumbler-wall", drink + " wall", placed(glass.liquid_glass, place));
    folder.add(drink + "-tumbler-level", drink + " level", placed(glass.liquid_air, place));
    folder.text("AttributeEnd\n");
}

}  // namespace

GlassCurves milk_glass_curves() {
    return {kMilkWall, kMilkBottom, 0.1};
}

std::vector<SceneFile> milk_scene(const ProceduralScene& scene) {
    SceneFolder folder(scene, kMilkHead);
    const Vec3d middle(kWaterMiddle[0], kWaterMiddle[1], 0);
    const DensityBox box = {
        middle + Vec3d(-2.2, -2.2, 1.9), middle + Vec3d(2.2, 2.2, 8.3), {36, 36, 52}};
    std::string materials(kMilkMaterials);
    materials += density_text(box, [&](const Vec3d& p) { return drop_density(p - middle); });
    folder.text(materials);
    folder.add("tablecloth", "cloth", square_mesh(40, 0));
    add_glass(folder, "milk", "milk", kMilkMiddle);
    add_glass(folder, "water", "drop", kWaterMiddle);
    std::vector<SceneFile> files = std::move(folder).files();
    const Vec3d sun(kMilkSun[0], kMilkSun[1], kMilkSun[2]);
    files.push_back({"geometry/milk-sky.pfm", clear_sky_pfm(sun.normalized(), 64)});
    return files;
}

}  // namespace sunfleck::engine
