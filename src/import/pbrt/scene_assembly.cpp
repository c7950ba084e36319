// Statements by way of the graphics state that each of them would find in a file.
#include "import/pbrt/scene_assembly.h"

#include "import/pbrt/finish.h"
#include "import/pbrt/lights.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/shapes.h"

#include <utility>

namespace sunfleck::engine {

struct SceneAssembly::Impl {
    explicit Impl(const std::string& path) : reading(path, disk_access()) {
        reading.in_world = true;
    }

    /// Makes a statement as if its graphics state held a matrix and media alone.
    template <class Make>
    void make(const Matrix& to_world, const Make& make) {
        reading.state = {};
        reading.open_object.reset();
        reading.state.matrix = {to_world, to_world};
        try {
            make();
        } catch (const MissingFile& missing) {
            reading.assets.files.note_missing(missing);
        }
    }

    /// The object of that name, which is made if there is none.
    std::uint32_t object_named(const std::string& name) {
        const auto next = static_cast<std::uint32_t>(reading.scene.objects.size());
        const auto [entry, is_new] = reading.objects.try_emplace(name, next);
        if (is_new) reading.scene.objects.emplace_back();
        return entry->second;
    }

    Reading reading;
};

SceneAssembly::SceneAssembly(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
SceneAssembly::~SceneAssembly() = default;
SceneAssembly::SceneAssembly(SceneAssembly&&) noexcept = default;
SceneAssembly& SceneAssembly::operator=(SceneAssembly&&) noexcept = default;

void SceneAssembly::set_camera(Statement camera, const Matrix& to_world,
                               const std::string& medium) {
    Reading& reading = impl_->reading;
    const Matrix from_world = to_world.inverse();
    reading.scene.media.at_camera = reading.media.number_of(medium, camera.where);
    reading.options.camera_from_world = {from_world, from_world};
    reading.options.camera = std::move(camera);
}

void SceneAssembly::set_film(Statement film) {
    impl_->reading.options.film = std::move(film);
}

void SceneAssembly::set_filter(Statement filter) {
    impl_->reading.options.filter = std::move(filter);
}

void SceneAssembly::add_material(const std::string& name, Statement material) {
    impl_->make(Matrix(), [&] { impl_->reading.materials.make(name, std::move(material)); });
}

void SceneAssembly::add_texture(const std::string& kind, const std::string& name, Statement texture,
                                const Matrix& to_world) {
    Reading& reading = impl_->reading;
    impl_->make(to_world,
                [&] { reading.assets.textures.add(kind, name, std::move(texture), to_world); });
}

void SceneAssembly::add_medium(Statement medium) {
    impl_->reading.media.make(std::move(medium));
}

void SceneAssembly::add_light(const Statement& light, const Matrix& to_world,
                              const std::string& medium) {
    Reading& reading = impl_->reading;
    impl_->make(to_world, [&] {
        reading.state.inside_medium = medium;
        reading.state.outside_medium = medium;
        sunfleck::engine::add_light(light, reading);
    });
}

void SceneAssembly::add_shape(const Statement& shape, const ShapePlacement& placement) {
    Reading& reading = impl_->reading;
    impl_->make(placement.to_world, [&] {
        GraphicsState& state = reading.state;
        if (!placement.material.empty())
            state.material = reading.materials.slot_of(placement.material, shape.where);
        if (placement.area_light)
            state.emission =
                std::make_shared<const AreaEmission>(area_emission(*placement.area_light, reading));
        state.inside_medium = placement.inside_medium;
        state.outside_medium = placement.outside_medium;
        state.reverse_orientation = placement.reverse_orientation;
        if (!placement.object.empty()) reading.open_object = impl_->object_named(placement.object);
        sunfleck::engine::add_shape(shape, reading);
    });
}

void SceneAssembly::add_instance(const std::string& object, const Matrix& to_world,
                                 const SourceLocation& where) {
    impl_->reading.instances.push_back({object, to_world, where});
}

SceneDescription SceneAssembly::finish() {
    return finish_scene(impl_->reading);
}

}  // namespace sunfleck::engine
