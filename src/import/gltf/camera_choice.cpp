// Cameras by name, and else by number.
#include "import/gltf/camera_choice.h"

#include <algorithm>
#include <array>
#include <vector>

namespace sunfleck::engine {
namespace {

/// A camera of the scene, with its own name and that of its node.
struct Named {
    GltfNode node;
    std::array<std::string, 2> names;
};

std::vector<Named> cameras_in(const GltfDocument& document, const GltfNodes& nodes) {
    std::vector<Named> cameras;
    for (const GltfNode& node : nodes.in_scene())
        if (const auto number = node.place.find("camera"))
            cameras.push_back({node,
                               {document.element("cameras", *number).text("name", ""),
                                node.place.text("name", "")}});
    return cameras;
}

std::string list_of(const std::vector<Named>& cameras) {
    std::string list;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const auto& names = cameras[i].names;
        const std::string& name = names[0].empty() ? names[1] : names[0];
        list += (i == 0 ? "" : ", ") + std::to_string(i + 1);
        if (!name.empty()) list += " \"" + name + '"';
    }
    return list;
}

}  // namespace

std::optional<GltfNode> chosen_camera(const GltfDocument& document, const GltfNodes& nodes,
                                      const std::string& chosen) {
    const std::vector<Named> cameras = cameras_in(document, nodes);
    if (chosen.empty()) {
        if (cameras.empty()) return {};
        return cameras.front().node;
    }
    for (const std::size_t kind : {0U, 1U})
        for (const Named& camera : cameras)
            if (camera.names.at(kind) == chosen) return camera.node;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        if (chosen == std::to_string(i + 1)) return cameras[i].node;
    const std::string what = "has no camera \"" + chosen + "\" (--camera)";
    throw Error({document.path()}, what,
                cameras.empty() ? "leave --camera out: the scene has no camera at all"
                                : "write one of " + list_of(cameras));
}

}  // namespace sunfleck::engine
