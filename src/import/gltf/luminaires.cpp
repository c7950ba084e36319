// Profiles are read once; each node places one.
#include "import/gltf/luminaires.h"

#include "import/gltf/units.h"
#include "import/gltf/uri.h"
#include "import/ies/light.h"
#include "scene/additions.h"

#include <map>
#include <memory>

namespace sunfleck::engine {
namespace {

using Maps = std::map<std::size_t, std::shared_ptr<const LightImage>>;

/// Returns the map of a profile, or null if its file is missing, which the document notes.
std::shared_ptr<const LightImage> map_of(const JsonPlace& profile, GltfDocument& document) {
    if (const auto view = profile.find("bufferView")) {
        const std::string_view bytes = document.bytes_of(document.element("bufferViews", *view));
        return intensity_map(Photometry(std::string(bytes), profile.where().file));
    }
    const JsonPlace uri = profile.at("uri");
    const std::string bytes = document.read(uri);
    if (bytes.empty()) return nullptr;
    const std::string name = is_data_uri(uri.text()) ? uri.where().file : uri.text();
    return intensity_map(Photometry(bytes, name));
}

/// Returns the rotation of a node.
Affine turn_of_node(const Matrix& to_world) {
    const auto row = [&](int i) { return Vec3d(to_world[i][0], to_world[i][1], to_world[i][2]); };
    Affine turn;
    turn.x = row(0).normalized();
    turn.y = (row(1) - turn.x * turn.x.dot(row(1))).normalized();
    turn.z = turn.x.cross(turn.y);
    if (turn.z.dot(row(2)) < 0) turn.z = -turn.z;
    return turn;
}

}  // namespace

void add_luminaires(GltfDocument& document, const GltfNodes& nodes, SceneDescription& scene) {
    const auto extension = document.root().extension("EXT_lights_ies");
    Maps maps;
    for (const GltfNode& node : nodes.in_scene()) {
        const auto use = node.place.extension("EXT_lights_ies");
        if (!use || !node.is_visible) continue;
        if (!extension) use->refuse("names a luminaire, but the file has none", "export it again");
        const JsonPlace profiles = extension->at("lights");
        const std::size_t number = use->at("light").index(profiles.size(), "light");
        const JsonPlace profile = profiles[number];
        if (!maps.contains(number)) maps[number] = map_of(profile, document);
        if (!maps[number]) continue;
        const double factor = use->number("multiplier", 1, 0, kMostLight) / kLumensPerWatt;
        const Spectrum curve = Spectrum::rgb_illuminant(Vec3(use->triple("color", Vec3d(1))))
                                   .scaled(static_cast<float>(factor));
        const Matrix& m = node.to_world;
        add_light(
            scene, {"luminaire \"" + profile.text("name", "unnamed") + '"', use->where()},
            GoniometricLight{curve, {m[3][0], m[3][1], m[3][2]}, maps[number], turn_of_node(m)});
    }
    document.check_missing();
}

}  // namespace sunfleck::engine
