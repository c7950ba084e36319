// Scenes from files and texts.
#include "sunfleck/scene.h"

#include "core/parallel.h"
#include "flags/scene_flags.h"
#include "import/load.h"
#include "import/pbrt/reader.h"
#include "library/guarded.h"
#include "library/scene_data.h"

#include <utility>

namespace sunfleck {

Scene built_scene(const SceneOptions& options,
                  const std::function<engine::SceneDescription()>& read,
                  const engine::Exposure& exposure) {
    if (options.isa != "avx2" && options.isa != "native")
        throw Error({"isa"}, "there is no \"" + options.isa + "\"", "use \"avx2\" or \"native\"");
    std::shared_ptr<const Scene::Data> data;
    guarded([&] {
        engine::ThreadPool(options.threads).run([&] {
            engine::SceneDescription description = read();
            std::vector<std::string> files = description.files;
            const engine::Camera camera = description.camera;
            data = std::make_shared<const Scene::Data>(
                Scene::Data{.scene = engine::Scene(std::move(description), options.isa),
                            .isa = options.isa,
                            .files = std::move(files),
                            .camera_in_world = camera,
                            .exposure = exposure});
        });
    });
    return Scene(std::move(data));
}

Scene Scene::load(const std::string& path, const SceneOptions& options) {
    const auto read = [&] {
        engine::SceneRequest request;
        for (const auto& [name, text] : options.flags)
            engine::set_scene_flag(request, engine::scene_flag(name), text);
        return engine::load_scene(path, request);
    };
    return built_scene(options, read, engine::usual_exposure(path));
}

Scene Scene::parse(const std::string& text, const std::string& name, const SceneOptions& options) {
    if (!options.flags.empty())
        throw Error({options.flags.front().first}, "a scene of a text has no flags",
                    "state it in the text");
    return built_scene(options, [&] { return engine::read_pbrt_text(text, name); });
}

Scene::Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

int Scene::width() const {
    return data_->scene.film().resolution.x;
}

int Scene::height() const {
    return data_->scene.film().resolution.y;
}

std::vector<std::string> Scene::warnings() const {
    std::vector<std::string> lines;
    for (const auto& entry : data_->scene.warnings().entries()) lines.push_back(entry.line());
    return lines;
}

const std::vector<std::string>& Scene::files() const {
    return data_->files;
}

std::vector<LightInfo> Scene::lights() const {
    std::vector<LightInfo> lights;
    for (const engine::LightStatement& statement : data_->scene.light_statements())
        lights.push_back({statement.what, statement.where.text()});
    return lights;
}

std::size_t Scene::triangle_count() const {
    return data_->scene.geometry().triangle_count();
}

}  // namespace sunfleck
