// bench_evenness: errors by classes of brightness, spots, and what the unseen surround costs.
//
// usage: bench_evenness -o DIR --method "NAME=PROGRAM FLAGS..." [--method ...]
//                       [--views cognac-2,...] [--surrounds .25,1,10] [--scenes cornell,...]
//                       [--reference-flags "FLAGS"] [--cpu-time 60] [--seeds 8]
//                       [--reference-time 1200] [--resolution 256] [--at-once 2]
// Each method renders each scene with each seed, for equal processor time by one thread; renders of
// the methods stand side by side in the list. References are independent of what is tested: see
// evenness/views.h. Whatever is in DIR is not rendered again, so that a run may be ended at any
// moment, and seeds, methods and scenes added later. Writes DIR/evenness.json and prints tables.
#include "evenness/report.h"
#include "image/atomic_file.h"
#include "program.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

namespace sunfleck::engine::bench {
namespace {

struct Settings {
    std::string folder;
    std::vector<std::string> methods;
    std::vector<std::string> views = view_names();
    std::vector<double> surrounds = {0.25, 1, 10};
    std::vector<std::string> scenes;
    std::string reference_flags = "--integrator bdpt";
    double cpu_seconds = 60;
    double reference_seconds = 1200;
    std::uint64_t seeds = 8;
    int resolution = 256;
    std::size_t at_once = 2;
};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

Method method_of(const std::string& text) {
    const std::size_t equals = text.find('=');
    std::vector<std::string> words = words_of(text.substr(equals + 1));
    const std::string program = std::filesystem::absolute(words.at(0)).string();
    words.erase(words.begin());
    return {text.substr(0, equals), program, words};
}

std::vector<TestScene> scenes_of(const Settings& settings) {
    std::vector<TestScene> scenes;
    for (const std::string& view : settings.views) {
        const auto more = scenes_of_view(settings.folder, view, settings.surrounds);
        scenes.insert(scenes.end(), more.begin(), more.end());
    }
    for (const std::string& scene : settings.scenes)
        scenes.push_back(other_scene(settings.folder, scene, words_of(settings.reference_flags)));
    return scenes;
}

/// Renders of a method on a scene: one a seed.
std::vector<Render> renders_of(const Settings& settings, const TestScene& scene,
                               const Method& method) {
    std::vector<Render> renders;
    for (std::uint64_t seed = 1; seed <= settings.seeds; ++seed)
        renders.push_back(
            {fmt::format("{}/renders/{}/{}/{}", settings.folder, scene.name, method.name, seed),
             scene.scene_file, method, seed, settings.cpu_seconds, settings.resolution});
    return renders;
}

/// All renders, seed by seed, methods side by side.
std::vector<Render> interleaved(const Settings& settings, const std::vector<TestScene>& scenes,
                                const std::vector<Method>& methods) {
    std::vector<Render> all;
    for (std::uint64_t seed = 0; seed < settings.seeds; ++seed)
        for (const TestScene& scene : scenes)
            for (const Method& method : methods)
                all.push_back(renders_of(settings, scene, method)[seed]);
    return all;
}

void run(const Settings& settings) {
    std::vector<Method> methods;
    for (const std::string& text : settings.methods) methods.push_back(method_of(text));
    const std::vector<TestScene> scenes = scenes_of(settings);
    const auto references_of = [&](const TestScene& scene) {
        return reference_renders(settings.folder, scene, methods.back().program,
                                 settings.reference_seconds, settings.resolution);
    };
    std::vector<Render> references;
    for (const TestScene& scene : scenes)
        for (const Render& render : references_of(scene)) references.push_back(render);
    make_renders(interleaved(settings, scenes, methods), settings.at_once);
    make_renders(references, settings.at_once);
    Results results{settings.cpu_seconds, settings.resolution, methods, {}};
    for (const TestScene& scene : scenes) {
        SceneResult result{scene, reference_of(scene, references_of(scene)), {}};
        for (const Method& method : methods)
            result.methods.push_back(
                errors_of(result.reference, renders_of(settings, scene, method)));
        results.scenes.push_back(std::move(result));
    }
    fmt::print("{}", results_text(results));
    write_file(settings.folder + "/evenness.json", evenness_json(results));
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    sunfleck::engine::bench::Settings settings;
    CLI::App app("Errors by classes of brightness, and what the surround costs");
    app.add_option("-o", settings.folder, "Folder of all renders")->required();
    app.add_option("--method", settings.methods, "NAME=PROGRAM FLAGS...; gains are over the first")
        ->required()
        ->check([](const std::string& text) {
            const std::size_t equals = text.find('=');
            const bool is_whole = equals != std::string::npos && equals > 0 &&
                                  text.find_first_not_of(' ', equals + 1) != std::string::npos;
            return is_whole ? std::string() : "a method is NAME=PROGRAM FLAGS...";
        });
    app.add_option("--views", settings.views, "Close-ups with a table of any size")
        ->delimiter(',')
        ->check(CLI::IsMember(sunfleck::engine::bench::view_names()));
    app.add_option("--surrounds", settings.surrounds, "Sides of the table over the scene's own")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_option("--scenes", settings.scenes, "Other procedural scenes, or scene files")
        ->delimiter(',');
    app.add_option("--reference-flags", settings.reference_flags, "How those have references");
    app.add_option("--cpu-time", settings.cpu_seconds, "Of a render, in seconds");
    app.add_option("--reference-time", settings.reference_seconds, "Of a part of a reference");
    app.add_option("--seeds", settings.seeds, "Renders of a method and scene");
    app.add_option("--resolution", settings.resolution, "Pixels a side");
    app.add_option("--at-once", settings.at_once, "Renders side by side");
    return sunfleck::engine::bench::run_program(app, count, words,
                                                [&] { sunfleck::engine::bench::run(settings); });
}
