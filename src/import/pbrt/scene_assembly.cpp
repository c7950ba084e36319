// Statements by way of the graphics state that each of them would find in a file.
#include "import/pbrt/scene_assembly.h"

#include "import/pbrt/finish.h"
#include "import/pbrt/lights.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/shapes.h"
#include "import/pbrt/statement_checks.h"

#include <utility>

namespace sunfleck::engine {

namespace {

/// One statement's warnings and changes of the reading's scratch values; dropped unless kept.
class Attempt {
public:
    explicit Attempt(Reading& reading)
        : reading_(reading),
          log_(std::exchange(reading.log, {})),
          curve_origin_(reading.curve_origin) {}
    ~Attempt() {
        reading_.log = std::move(log_);
        reading_.curve_origin = curve_origin_;
    }
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    Attempt(Attempt&&) = delete;
    Attempt& operator=(Attempt&&) = delete;

    void keep() {
        log_.append(reading_.log);
        curve_origin_ = reading_.curve_origin;
    }

private:
    Reading& reading_;
    ImportLog log_;  // of the statements before
    Vec3d curve_origin_;
};

}  // namespace

struct SceneAssembly::Impl {
    explicit Impl(const std::string& path) : reading(path, disk_access()), checks(path) {
        reading.in_world = true;
    }

    /// Makes a statement as if its graphics state held a matrix and media alone. If it throws, its
    /// warnings are dropped.
    /// @param make  must change nothing else of the reading before it throws.
    template <class Make>
    void make(const Matrix& to_world, const Make& make) {
        reading.state = {};
        reading.open_object.reset();
        reading.state.matrix = {to_world, to_world};
        Attempt attempt(reading);
        try {
            make();
        } catch (const MissingFile& missing) {
            reading.assets.files.note_missing(missing);
        }
        attempt.keep();
    }

    /// Returns the number of an object, or that of the next one if there is none of that name.
    std::uint32_t object_named(const std::string& name) const {
        const auto found = reading.objects.find(name);
        if (found != reading.objects.end()) return found->second;
        return static_cast<std::uint32_t>(reading.scene.objects.size());
    }

    void make_object(const std::string& name) {
        if (reading.objects.try_emplace(name, object_named(name)).second)
            reading.scene.objects.emplace_back();
    }

    Reading reading;
    StatementChecks checks;
};

SceneAssembly::SceneAssembly(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
SceneAssembly::~SceneAssembly() = default;
SceneAssembly::SceneAssembly(SceneAssembly&&) noexcept = default;
SceneAssembly& SceneAssembly::operator=(SceneAssembly&&) noexcept = default;

void SceneAssembly::set_camera(Statement camera, const Matrix& to_world,
                               const std::string& medium) {
    check_camera(camera, to_world);
    Options& options = impl_->reading.options;
    const Matrix from_world = to_world.inverse();
    options.camera_medium = medium;
    options.camera_from_world = {from_world, from_world};
    options.camera = std::move(camera);
}

void SceneAssembly::set_film(Statement film) {
    check_film(film);
    impl_->reading.options.film = std::move(film);
}

void SceneAssembly::set_filter(Statement filter) {
    check_filter(filter);
    impl_->reading.options.filter = std::move(filter);
}

void SceneAssembly::add_material(const std::string& name, Statement material) {
    impl_->checks.material(name, material);
    impl_->reading.materials.make(name, std::move(material));
}

void SceneAssembly::add_texture(const std::string& kind, const std::string& name, Statement texture,
                                const Matrix& to_world) {
    impl_->checks.texture(kind, name, texture, to_world);
    TextureTable& textures = impl_->reading.assets.textures;
    impl_->make(to_world, [&] { textures.add(kind, name, std::move(texture), to_world); });
}

void SceneAssembly::add_medium(Statement medium) {
    impl_->checks.medium(medium);
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
        if (placement.area_light)
            state.emission =
                std::make_shared<const AreaEmission>(area_emission(*placement.area_light, reading));
        state.inside_medium = placement.inside_medium;
        state.outside_medium = placement.outside_medium;
        state.reverse_orientation = placement.reverse_orientation;
        if (!placement.object.empty()) reading.open_object = impl_->object_named(placement.object);
        auto made = shape_of(shape, reading);
        // The statement is right: from here on it changes the scene.
        if (!placement.object.empty()) impl_->make_object(placement.object);
        if (!placement.material.empty())
            state.material = reading.materials.slot_of(placement.material, shape.where);
        const std::uint32_t light =
            placement.area_light ? note_light(*placement.area_light, reading) : kNone;
        if (made && made->emission) made->emission->statement = light;
        if (made) place_shape(std::move(*made), reading);
    });
}

void SceneAssembly::add_instance(const std::string& object, const Matrix& to_world,
                                 const SourceLocation& where) {
    impl_->reading.instances.push_back({object, to_world, where});
}

SceneDescription SceneAssembly::finish() const {
    Reading whole(impl_->reading);
    return finish_scene(whole);
}

}  // namespace sunfleck::engine
