// Lights shine along -z of their node.
#include "import/gltf/lights.h"

#include "import/gltf/units.h"
#include "math/trigonometry.h"
#include "scene/additions.h"

#include <algorithm>
#include <optional>
#include <string>

namespace sunfleck::engine {
namespace {

/// Returns the direction of a light; zero where its node is scaled to nothing.
Vec3d axis_of(const Matrix& to_world) {
    return -Vec3d(to_world[2][0], to_world[2][1], to_world[2][2]).normalized();
}

/// Exporters that hold angles as floats write half a sphere a little too wide, and cones without a
/// soft edge as two of the same width.
SpotLight spot_of(const JsonPlace& light, Warnings& warnings) {
    static constexpr double kMost = kPiDouble / 2;
    constexpr double kRounding = 1e-6;
    const auto spot = light.find("spot");
    const JsonPlace& place = spot ? *spot : light;
    const double inner = place.number("innerConeAngle", 0, 0, kMost + kRounding);
    const double outer = place.number("outerConeAngle", kPiDouble / 4, 0, kMost + kRounding);
    if (!(inner < outer))
        warnings.add(place.where(), "the outer cone is not wider than the inner: its edge is hard");
    const auto cosine = [](double angle) {
        return sin_cos_2pi(std::min(angle, kMost) / (2 * kPiDouble)).cos;
    };
    SpotLight made;
    made.edge = SpotEdge::square;
    made.cos_total = cosine(outer);
    made.cos_start = std::max(cosine(inner), made.cos_total);
    return made;
}

/// Returns a light; nothing where it has no direction.
std::optional<Light> made_light(const JsonPlace& light, const Matrix& to_world,
                                Warnings& warnings) {
    const double intensity = light.number("intensity", 1, 0, kMostLight) / kLumensPerWatt;
    const Spectrum curve = Spectrum::rgb_illuminant(Vec3(light.triple("color", Vec3d(1))))
                               .scaled(static_cast<float>(intensity));
    const Vec3d position(to_world[3][0], to_world[3][1], to_world[3][2]);
    const JsonPlace type = light.at("type");
    if (type.text() == "point") return PointLight{curve, position};
    if (type.text() != "spot" && type.text() != "directional")
        type.refuse("is no type of light", "write point, spot or directional");
    const Vec3d axis = axis_of(to_world);
    if (axis == Vec3d(0)) return {};
    if (type.text() == "directional") return DistantLight{curve, axis};
    SpotLight spot = spot_of(light, warnings);
    spot.curve = curve;
    spot.position = position;
    spot.axis = axis;
    return spot;
}

}  // namespace

void add_punctual_lights(const GltfDocument& document, const GltfNodes& nodes,
                         SceneDescription& scene) {
    const auto extension = document.root().extension("KHR_lights_punctual");
    for (const GltfNode& node : nodes.in_scene()) {
        const auto use = node.place.extension("KHR_lights_punctual");
        if (!use || !node.is_visible) continue;
        if (!extension) use->refuse("names a light, but the file has none", "export it again");
        const JsonPlace lights = extension->at("lights");
        const JsonPlace light = lights[use->at("light").index(lights.size(), "light")];
        const auto made = made_light(light, node.to_world, scene.warnings);
        if (made)
            add_light(
                scene,
                {"light \"" + light.text("name", light.at("type").text()) + '"', light.where()},
                *made);
        else
            scene.warnings.add(node.place.where(), "is scaled to nothing: its light is left out");
    }
}

}  // namespace sunfleck::engine
