// Views and their files.
#include "evenness/views.h"

#include "experiment/store.h"
#include "procedural/cognac.h"
#include "procedural/placement.h"
#include "procedural/scenes.h"
#include "procedural/wine_glass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace sunfleck::engine::bench {
namespace {

namespace fs = std::filesystem;

using MakeScene = std::vector<SceneFile> (*)(std::string_view view, const Mesh& table);

template <class Views>
const auto& row_of(const Views& views, std::string_view name) {
    return *std::find_if(views.begin(), views.end(),
                         [&](const auto& view) { return view.name == name; });
}

std::vector<SceneFile> cognac(std::string_view view, const Mesh& table) {
    return cognac_scene(row_of(kCognacViews, view), table);
}

std::vector<SceneFile> wine_glass(std::string_view view, const Mesh& table) {
    return wine_glass_scene(row_of(kWineGlassViews, view), table);
}

struct View {
    std::string_view name;
    MakeScene make;
    double half_width;        // of the scene's own table
    double small_half_width;  // of the smallest that holds what the picture shows
    Vec3d small_middle;       // of tables smaller than the scene's own
};

/// The small tables hold the foot of the glass, too.
constexpr double kSmallCognac = 7.75;
constexpr double kSmallWine = 16;
const std::array<View, 4> kViews = {{
    {"cognac-2", cognac, kTableHalfWidth, kSmallCognac, {2.2, -4.2, 0}},
    {"cognac-4", cognac, kTableHalfWidth, kSmallCognac, {2.2, -4.2, 0}},
    {"wine-glass-2", wine_glass, kWineTableHalfWidth, kSmallWine, {6, 4, 0}},
    {"wine-glass-3", wine_glass, kWineTableHalfWidth, kSmallWine, {6, 4, 0}},
}};

std::string written_view(const fs::path& folder, const View& view, double half_width) {
    const Vec3d middle = half_width < view.half_width ? view.small_middle : Vec3d(0);
    const Mesh table = placed(square_mesh(static_cast<float>(half_width), 0), at(middle));
    return write_scene(folder.string(), view.make(view.name, table));
}

}  // namespace

std::vector<std::string> view_names() {
    std::vector<std::string> names;
    for (const View& view : kViews) names.emplace_back(view.name);
    return names;
}

std::vector<TestScene> scenes_of_view(const std::string& folder, const std::string& view,
                                      const std::vector<double>& surrounds) {
    const View& row = row_of(kViews, view);
    const fs::path base = fs::path(folder) / "scenes";
    const ReferencePart caustic = {
        view + "-caustic",
        written_view(base / (view + "-small"), row, row.small_half_width),
        {"--photon-sampler", "uniform", "--radius-pixels", "0.5"},
        true};
    std::vector<TestScene> scenes;
    for (const double surround : surrounds) {
        TestScene scene{fmt::format("{}@{:g}", view, surround), view, surround, {}, {caustic}};
        const double half_width = std::max(row.small_half_width, row.half_width * surround);
        scene.scene_file = written_view(base / scene.name, row, half_width);
        scene.reference.push_back(
            {scene.name + "-path", scene.scene_file, {"--integrator", "path"}, false});
        scenes.push_back(scene);
    }
    return scenes;
}

TestScene other_scene(const std::string& folder, const std::string& scene,
                      const std::vector<std::string>& flags) {
    TestScene result{scene, scene, 1, scene, {}};
    if (scene.ends_with(".pbrt"))
        result.name = result.view = fs::path(scene).stem().string();
    else
        result.scene_file = write_scene(folder + "/scenes/" + scene, make_scene(scene));
    result.reference.push_back({result.name + "-reference", result.scene_file, flags, false});
    return result;
}

}  // namespace sunfleck::engine::bench
