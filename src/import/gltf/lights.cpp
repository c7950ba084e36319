// Lights shine along -z of their node.
#include "import/gltf/lights.h"

#include "import/gltf/units.h"
#include "math/trigonometry.h"
#include "scene/additions.h"

#include <string>

namespace sunfleck::engine {
namespace {

Vec3d axis_of(const Matrix& to_world) {
    return -Vec3d(to_world[2][0], to_world[2][1], to_world[2][2]).normalized();
}

SpotLight spot_of(const JsonPlace& light) {
    const auto spot = light.find("spot");
    const JsonPlace& place = spot ? *spot : light;
    const double inner = place.number("innerConeAngle", 0, 0, kPiDouble / 2);
    const double outer = place.number("outerConeAngle", kPiDouble / 4, 0, kPiDouble / 2);
    if (!(inner < outer)) place.refuse("has no outer cone beyond the inner", "make it wider");
    SpotLight made;
    made.cos_start = sin_cos_2pi(inner / (2 * kPiDouble)).cos;
    made.cos_total = sin_cos_2pi(outer / (2 * kPiDouble)).cos;
    return made;
}

Light made_light(const JsonPlace& light, const Matrix& to_world) {
    const double intensity = light.number("intensity", 1, 0, kMostLight) / kLumensPerWatt;
    const Spectrum curve = Spectrum::rgb_illuminant(Vec3(light.triple("color", Vec3d(1))))
                               .scaled(static_cast<float>(intensity));
    const Vec3d position(to_world[3][0], to_world[3][1], to_world[3][2]);
    const JsonPlace type = light.at("type");
    if (type.text() == "point") return PointLight{curve, position};
    if (type.text() == "directional") return DistantLight{curve, axis_of(to_world)};
    if (type.text() != "spot")
        type.refuse("is no type of light", "write point, spot or directional");
    SpotLight spot = spot_of(light);
    spot.curve = curve;
    spot.position = position;
    spot.axis = axis_of(to_world);
    return spot;
}

}  // namespace

void add_punctual_lights(const GltfDocument& document, const GltfNodes& nodes,
                         SceneDescription& scene) {
    const auto extension = document.root().extension("KHR_lights_punctual");
    for (const GltfNode& node : nodes.in_scene()) {
        const auto use = node.place.extension("KHR_lights_punctual");
        if (!use) continue;
        if (!extension) use->refuse("names a light, but the file has none", "export it again");
        const JsonPlace lights = extension->at("lights");
        const JsonPlace light = lights[use->at("light").index(lights.size(), "light")];
        add_light(scene,
                  {"light \"" + light.text("name", light.at("type").text()) + '"', light.where()},
                  made_light(light, node.to_world));
    }
}

}  // namespace sunfleck::engine
