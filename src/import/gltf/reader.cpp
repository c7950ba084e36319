// A scene from its nodes: shapes, instances, lights, view.
#include "import/gltf/reader.h"

#include "geometry/affine.h"
#include "import/gltf/lights.h"
#include "import/gltf/shapes.h"
#include "import/gltf/units.h"
#include "import/gltf/view.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Extensions that are read. Others are named in a warning, or refused where they are required.
constexpr std::array<std::string_view, 9> kExtensions = {
    "EXT_mesh_gpu_instancing",  "KHR_lights_punctual",
    "KHR_materials_dispersion", "KHR_materials_emissive_strength",
    "KHR_materials_ior",        "KHR_materials_transmission",
    "KHR_materials_volume",     "KHR_mesh_quantization",
    "KHR_texture_transform"};

/// Extensions that change no picture.
bool is_harmless(std::string_view name) {
    return name.starts_with("KHR_xmp") || name == "KHR_animation_pointer";
}

void check_extensions(const GltfDocument& document, SceneDescription& scene) {
    const auto is_read = [](const std::string& name) {
        return std::find(kExtensions.begin(), kExtensions.end(), name) != kExtensions.end();
    };
    for (const JsonPlace& required : document.root().elements("extensionsRequired"))
        if (!is_read(required.text()))
            required.refuse("requires the extension " + required.text() + ", which is not read",
                            "export the scene without it");
    for (const JsonPlace& used : document.root().elements("extensionsUsed"))
        if (!is_read(used.text()) && !is_harmless(used.text()))
            scene.warnings.add(used.where(), "the extension " + used.text() +
                                                 " is not read: what it adds is left out");
}

class GltfReading {
public:
    GltfReading(GltfDocument& document, SceneDescription scene)
        : scene_(std::move(scene)),
          document_(document),
          accessors_(document_),
          nodes_(document_, accessors_),
          shapes_(document_, accessors_, nodes_, scene_) {}

    SceneDescription read() {
        for (const GltfNode& node : nodes_.in_scene())
            if (const auto mesh = node.place.find("mesh"))
                uses_[number_of(*mesh)] += nodes_.instances_of(node).size();
        for (const GltfNode& node : nodes_.in_scene()) add_node(node);
        add_punctual_lights(document_, nodes_, scene_);
        if (scene_.lights.empty() && !emits()) add_sky();
        set_view(document_, nodes_, scene_);
        if (document_.root().find("animations"))
            scene_.warnings.add({scene_.path}, "animations are left out: all stands as at rest");
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
        const bool has_pose = has_skin || node.place.find("weights");
        if (!has_pose && uses_.at(number_of(*number)) > 1) {
            add_instances(node, mesh, number_of(*number));
            return;
        }
        const std::vector<Matrix> frames = nodes_.instances_of(node);
        if (frames.empty()) return;
        for (ShapeDescription& shape : shapes_.of(node.place, mesh)) {
            if (!has_skin) shape.placed.to_world = frames.front();
            scene_.shapes.push_back(std::move(shape));
        }
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
        for (ShapeDescription& shape : shapes_.of(node.place, mesh))
            (shape.emission ? shared.emitting : object).push_back(std::move(shape));
        if (object.empty()) return shared;
        shared.object = static_cast<std::uint32_t>(scene_.objects.size());
        scene_.objects.push_back(std::move(object));
        return shared;
    }

    void add_instances(const GltfNode& node, const JsonPlace& mesh, std::size_t number) {
        if (!shared_.contains(number)) shared_.emplace(number, shared_of(node, mesh));
        const Shared& shared = shared_.at(number);
        for (const Matrix& frame : nodes_.instances_of(node)) {
            if (!Affine(frame).is_invertible()) {
                scene_.warnings.add(node.place.where(), "is flat or too small, and left out");
                continue;
            }
            if (shared.object) scene_.instances.push_back({*shared.object, frame});
            for (ShapeDescription shape : shared.emitting) {
                shape.placed.to_world = frame;
                scene_.shapes.push_back(std::move(shape));
            }
        }
    }

    bool emits() const {
        return std::any_of(scene_.shapes.begin(), scene_.shapes.end(),
                           [](const ShapeDescription& s) { return s.emission.has_value(); });
    }

    void add_sky() {
        scene_.warnings.add({scene_.path}, "there is no light: an even white sky is used");
        scene_.stated_in.push_back(static_cast<std::uint32_t>(scene_.light_statements.size()));
        scene_.light_statements.push_back({"sky", {scene_.path}});
        constexpr auto kNit = static_cast<float>(1 / kLumensPerWatt);
        scene_.lights.emplace_back(InfiniteLight{Spectrum::d65().scaled(kNit)});
    }

    SceneDescription scene_;
    GltfDocument& document_;
    Accessors accessors_;
    GltfNodes nodes_;
    GltfShapes shapes_;
    std::map<std::size_t, std::size_t> uses_;  // of each mesh
    std::map<std::size_t, Shared> shared_;
};

}  // namespace

SceneDescription read_gltf(const std::string& path, const ImportSettings&) {
    GltfDocument document(path);
    SceneDescription scene;
    scene.path = path;
    scene.film.imaging_ratio = static_cast<float>(kLumensPerWatt);  // a pixel of 1 is 1 cd/m2
    check_extensions(document, scene);
    return GltfReading(document, std::move(scene)).read();
}

}  // namespace sunfleck::engine
