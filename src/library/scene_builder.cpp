// Calls as statements of a scene that is put together in memory.
#include "sunfleck/scene_builder.h"

#include "import/pbrt/scene_assembly.h"
#include "library/guarded.h"
#include "library/matrices.h"
#include "library/scene_data.h"
#include "library/statements.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace sunfleck {

struct SceneBuilder::Impl {
    explicit Impl(const std::string& folder)
        : path((std::filesystem::path(folder) / "scene in memory").string()), assembly(path) {}

    /// Adds the shape of the statement that statement(where) returns.
    template <class MakeStatement>
    void add_shape(const ShapeOptions& options, const MakeStatement& statement);

    std::string path;
    engine::SceneAssembly assembly;
    // Calls of each kind that did not throw.
    int shapes = 0;
    int lights = 0;
    int instances = 0;
};

namespace {

engine::ShapePlacement placement_of(const ShapeOptions& options, const std::string& where) {
    engine::ShapePlacement placement;
    placement.material = options.material;
    placement.to_world = matrix_of(options.to_world);
    if (options.area_light)
        placement.area_light =
            statement_of("AreaLightSource", "diffuse", *options.area_light, where);
    placement.inside_medium = options.inside_medium;
    placement.outside_medium = options.outside_medium;
    placement.reverse_orientation = options.reverse_orientation;
    placement.object = options.object;
    return placement;
}

std::vector<std::int32_t> indices_of(std::span<const std::uint32_t> triangles,
                                     const std::string& where) {
    std::vector<std::int32_t> indices;
    indices.reserve(triangles.size());
    for (const std::uint32_t index : triangles) {
        if (index > std::uint32_t{INT32_MAX})
            throw Error({where}, "index " + std::to_string(index) + " is that of no vertex",
                        "count vertices from 0");
        indices.push_back(static_cast<std::int32_t>(index));
    }
    return indices;
}

/// Calls task(impl) on what a builder has. A builder that was moved from is as if new.
template <class Impl, class Task>
void change(std::unique_ptr<Impl>& impl, const Task& task) {
    guarded([&] {
        if (!impl) impl = std::make_unique<Impl>(".");
        task(*impl);
    });
}

}  // namespace

template <class MakeStatement>
void SceneBuilder::Impl::add_shape(const ShapeOptions& options, const MakeStatement& statement) {
    const std::string where = "shape " + std::to_string(shapes + 1);
    assembly.add_shape(statement(where), placement_of(options, where));
    ++shapes;
}

SceneBuilder::SceneBuilder(const std::string& folder) : impl_(std::make_unique<Impl>(folder)) {}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;

void SceneBuilder::camera(const std::string& type, const Parameters& parameters,
                          const Transform& to_world, const std::string& medium) {
    change(impl_, [&](Impl& impl) {
        impl.assembly.set_camera(statement_of("Camera", type, parameters, "camera"),
                                 matrix_of(to_world), medium);
    });
}

void SceneBuilder::film(int width, int height, const Parameters& parameters) {
    change(impl_, [&](Impl& impl) {
        Parameters all = parameters;
        all.push_back({"integer xresolution", width});
        all.push_back({"integer yresolution", height});
        impl.assembly.set_film(statement_of("Film", "rgb", all, "film"));
    });
}

void SceneBuilder::filter(const std::string& type, const Parameters& parameters) {
    change(impl_, [&](Impl& impl) {
        impl.assembly.set_filter(statement_of("PixelFilter", type, parameters, "filter"));
    });
}

void SceneBuilder::material(const std::string& name, const std::string& type,
                            const Parameters& parameters) {
    change(impl_, [&](Impl& impl) {
        Parameters all = parameters;
        all.push_back({"string type", type});
        const std::string where = "material \"" + name + "\"";
        impl.assembly.add_material(name, statement_of("MakeNamedMaterial", name, all, where));
    });
}

void SceneBuilder::texture(const std::string& name, const std::string& kind,
                           const std::string& type, const Parameters& parameters,
                           const Transform& to_world) {
    change(impl_, [&](Impl& impl) {
        const std::string where = "texture \"" + name + "\"";
        impl.assembly.add_texture(kind, name, statement_of("Texture", type, parameters, where),
                                  matrix_of(to_world));
    });
}

void SceneBuilder::medium(const std::string& name, const std::string& type,
                          const Parameters& parameters) {
    change(impl_, [&](Impl& impl) {
        Parameters all = parameters;
        all.push_back({"string type", type});
        impl.assembly.add_medium(
            statement_of("MakeNamedMedium", name, all, "medium \"" + name + "\""));
    });
}

void SceneBuilder::light(const std::string& type, const Parameters& parameters,
                         const Transform& to_world, const std::string& medium) {
    change(impl_, [&](Impl& impl) {
        const std::string where = "light " + std::to_string(impl.lights + 1);
        impl.assembly.add_light(statement_of("LightSource", type, parameters, where),
                                matrix_of(to_world), medium);
        ++impl.lights;
    });
}

void SceneBuilder::shape(const std::string& type, const Parameters& parameters,
                         const ShapeOptions& options) {
    change(impl_, [&](Impl& impl) {
        impl.add_shape(options, [&](const std::string& where) {
            return statement_of("Shape", type, parameters, where);
        });
    });
}

void SceneBuilder::mesh(const Mesh& mesh, const ShapeOptions& options) {
    change(impl_, [&](Impl& impl) {
        impl.add_shape(options, [&](const std::string& where) {
            Parameters parameters = {{"point3 P", mesh.positions},
                                     {"integer indices", indices_of(mesh.triangles, where)}};
            if (!mesh.normals.empty()) parameters.push_back({"normal N", mesh.normals});
            if (!mesh.uvs.empty()) parameters.push_back({"point2 uv", mesh.uvs});
            return statement_of("Shape", "trianglemesh", parameters, where);
        });
    });
}

void SceneBuilder::instance(const std::string& object, const Transform& to_world) {
    change(impl_, [&](Impl& impl) {
        impl.assembly.add_instance(object, matrix_of(to_world),
                                   {"instance " + std::to_string(impl.instances + 1)});
        ++impl.instances;
    });
}

Scene SceneBuilder::build(const SceneOptions& options) {
    std::optional<Scene> scene;
    change(impl_, [&](Impl& impl) {
        scene = built_scene(options, [&] { return impl.assembly.finish(); });
        const std::string folder = std::filesystem::path(impl.path).parent_path().string();
        impl_ = std::make_unique<Impl>(folder);
    });
    return *std::move(scene);
}

}  // namespace sunfleck
