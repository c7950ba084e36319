// A scene from its nodes: shapes, instances, lights, view.
#include "import/gltf/reader.h"

#include "geometry/affine.h"
#include "import/gltf/draco.h"
#include "import/gltf/lights.h"
#include "import/gltf/luminaires.h"
#include "import/gltf/meshopt.h"
#include "import/gltf/shapes.h"
#include "import/gltf/units.h"
#include "import/gltf/view.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Extensions that are read. Others are named in a warning, or refused where they are required.
constexpr std::array<std::string_view, 22> kExtensions = {"EXT_lights_ies",
                                                          "EXT_mesh_gpu_instancing",
                                                          "EXT_texture_webp",
                                                          "KHR_lights_punctual",
                                                          "KHR_materials_anisotropy",
                                                          "KHR_materials_clearcoat",
                                                          "KHR_materials_diffuse_transmission",
                                                          "KHR_materials_dispersion",
                                                          "KHR_materials_emissive_strength",
                                                          "KHR_materials_ior",
                                                          "KHR_materials_iridescence",
                                                          "KHR_materials_sheen",
                                                          "KHR_materials_specular",
                                                          "KHR_materials_transmission",
                                                          "KHR_materials_unlit",
                                                          "KHR_materials_variants",
                                                          "KHR_materials_volume",
                                                          "KHR_materials_volume_scatter",
                                                          "KHR_mesh_primitive_restart",
                                                          "KHR_mesh_quantization",
                                                          "KHR_node_visibility",
                                                          "KHR_texture_transform"};

/// Extensions that change no picture.
bool is_harmless(std::string_view name) {
    return name.starts_with("KHR_xmp") || name == "KHR_animation_pointer" ||
           name == "EXT_mesh_primitive_restart";
}

/// @throws Error  for an extension that other builds of this program read.
void check_built_in(const JsonPlace& extension) {
    const auto refuse = [&](const std::string& library, const std::string& package) {
        extension.refuse("requires the extension " + extension.text() +
                             ", but this program is built without " + library,
                         "build it with " + package + ", or export the scene without it");
    };
    if (extension.text() == "KHR_draco_mesh_compression") refuse("Draco", "libdraco-dev");
    if (extension.text() == "EXT_meshopt_compression")
        refuse("meshoptimizer", "libmeshoptimizer-dev");
}

void check_extensions(const GltfDocument& document, SceneDescription& scene) {
    const auto is_read = [](const std::string& name) {
        if (name == "KHR_draco_mesh_compression") return has_draco();
        if (name == "EXT_meshopt_compression") return has_meshopt();
        return std::find(kExtensions.begin(), kExtensions.end(), name) != kExtensions.end();
    };
    for (const JsonPlace& required : document.root().elements("extensionsRequired"))
        if (!is_read(required.text())) {
            check_built_in(required);
            required.refuse("requires the extension " + required.text() + ", which is not read",
                            "export the scene without it");
        }
    for (const JsonPlace& used : document.root().elements("extensionsUsed"))
        if (!is_read(used.text()) && !is_harmless(used.text()) &&
            used.text() != "KHR_texture_basisu")  // named where textures have it
            scene.warnings.add(used.where(), "the extension " + used.text() +
                                                 " is not read: what it adds is left out");
}

/// Tells which scene is shown, unless the file chooses.
void tell_scene(const GltfDocument& document, SceneDescription& scene) {
    if (document.root().find("scene")) return;
    const std::size_t scenes = document.count("scenes");
    if (scenes == 0 && document.count("nodes") > 0)
        scene.warnings.add({document.path()}, "has no scene: all its nodes are shown");
    if (scenes > 1)
        scene.warnings.add({document.path()}, "has " + std::to_string(scenes) +
                                                  " scenes and chooses none: the first is shown");
}

Accessors unpacked_accessors(const GltfDocument& document) {
    Accessors accessors(document);
    unpack_draco(document, accessors);
    return accessors;
}

class GltfReading {
public:
    GltfReading(GltfDocument& document, const ImportSettings& settings, SceneDescription scene)
        : scene_(std::move(scene)),
          document_(document),
          settings_(settings),
          accessors_(unpacked_accessors(document_)),
          nodes_(document_, accessors_,
                 poses_at(settings.frame_time, document_, accessors_, scene_.warnings)),
          shapes_(document_, accessors_, nodes_, scene_, settings) {}

    SceneDescription read() {
        for (const GltfNode& node : nodes_.in_scene())
            if (const auto mesh = node.place.find("mesh"); mesh && node.is_visible)
                uses_[number_of(*mesh)] += nodes_.instances_of(node).size();
        for (const GltfNode& node : nodes_.in_scene())
            if (node.is_visible) add_node(node);
        add_punctual_lights(document_, nodes_, scene_);
        add_luminaires(document_, nodes_, scene_);
        shapes_.tell_glass();
        set_view(document_, nodes_, settings_.camera, scene_);
        scene_.files = document_.files();
        return std::move(scene_);
    }

private:
    std::size_t number_of(const JsonPlace& mesh) const {
        return mesh.index(document_.count("meshes"), "mesh");
    }

    void add_node(const GltfNode& node) {
        const auto number = node.place.find("mesh");
        if (!number) return;
        const JsonPlace mesh = document_.element("meshes", *number);
        const bool has_skin = node.place.find("skin").has_value();
        const bool has_pose = has_skin || node.place.find("weights") || !node.weights.empty();
        if (!has_pose && uses_.at(number_of(*number)) > 1) {
            add_instances(node, mesh, number_of(*number));
            return;
        }
        const std::vector<Matrix> frames = nodes_.instances_of(node);
        if (frames.empty()) return;
        if (!has_skin && !is_there(node, frames.front())) return;
        for (ShapeDescription& shape : shapes_.of(node, mesh)) {
            shape.name = name_of(node, mesh);
            if (!has_skin) shape.placed.to_world = frames.front();
            scene_.shapes.push_back(std::move(shape));
        }
    }

    /// Returns the name of what a node shows: its own, or else that of its mesh.
    std::string name_of(const GltfNode& node, const JsonPlace& mesh) const {
        const std::string name = node.place.text("name", "");
        if (!name.empty()) return name;
        const std::string of_mesh = mesh.text("name", "");
        if (!of_mesh.empty()) return of_mesh;
        return "mesh " + std::to_string(number_of(node.place.at("mesh")));
    }

    /// What nodes that show the same mesh share: an object, and shapes that emit, which are placed
    /// one by one.
    struct Shared {
        std::optional<std::uint32_t> object{};
        std::vector<ShapeDescription> emitting{};
    };

    Shared shared_of(const GltfNode& node, const JsonPlace& mesh) {
        Shared shared;
        std::vector<ShapeDescription> object;
        for (ShapeDescription& shape : shapes_.of(node, mesh))
            (shape.emission ? shared.emitting : object).push_back(std::move(shape));
        if (object.empty()) return shared;
        shared.object = static_cast<std::uint32_t>(scene_.objects.size());
        scene_.objects.push_back(std::move(object));
        return shared;
    }

    /// Returns whether a frame has a volume; if not, a warning tells that what it has is left out.
    bool is_there(const GltfNode& node, const Matrix& frame) {
        if (Affine(frame).is_invertible()) return true;
        scene_.warnings.add(node.place.where(), "is flat or too small, and left out");
        return false;
    }

    void add_instances(const GltfNode& node, const JsonPlace& mesh, std::size_t number) {
        if (!shared_.contains(number)) shared_.emplace(number, shared_of(node, mesh));
        const Shared& shared = shared_.at(number);
        for (const Matrix& frame : nodes_.instances_of(node)) {
            if (!is_there(node, frame)) continue;
            const std::string name = name_of(node, mesh);
            if (shared.object) scene_.instances.push_back({*shared.object, frame, name});
            for (ShapeDescription shape : shared.emitting) {
                shape.placed.to_world = frame;
                shape.name = name;
                scene_.shapes.push_back(std::move(shape));
            }
        }
    }

    SceneDescription scene_;
    GltfDocument& document_;
    const ImportSettings& settings_;
    Accessors accessors_;
    GltfNodes nodes_;
    GltfShapes shapes_;
    std::map<std::size_t, std::size_t> uses_;  // of each mesh
    std::map<std::size_t, Shared> shared_;
};

}  // namespace

SceneDescription read_gltf(const std::string& path, const ImportSettings& settings) {
    GltfDocument document(path);
    return read_gltf_document(document, settings);
}

SceneDescription read_gltf_document(GltfDocument& document, const ImportSettings& settings) {
    SceneDescription scene;
    scene.path = document.path();
    scene.film.imaging_ratio = static_cast<float>(kLumensPerWatt);  // a pixel of 1 is 1 cd/m2
    check_extensions(document, scene);
    tell_scene(document, scene);
    return GltfReading(document, settings, std::move(scene)).read();
}

}  // namespace sunfleck::engine
