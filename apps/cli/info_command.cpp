// `sunfleck info`: what was read, what is approximated, lights, bounds, triangles.
#include "apps/cli/commands.h"
#include "core/memory_room.h"
#include "core/thread_trial.h"
#include "import/load.h"
#include "import/pbrt/vocabulary.h"
#include "render/memory_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace sunfleck::engine {
namespace {

void print_lights(const Scene& scene) {
    std::map<std::string, std::pair<int, double>> kinds;  // count, share of the photons
    for (std::size_t i = 0; i < scene.lights().size(); ++i) {
        auto& [count, share] = kinds[std::string(name_of(scene.lights()[i]))];
        ++count;
        share += scene.light_choice().probability(i);
    }
    for (const auto& [name, kind] : kinds)
        fmt::print("lights      {} {} ({:.3g}% of the photons)\n", kind.first, name,
                   100 * kind.second);
    if (kinds.empty()) fmt::print("lights      none\n");
}

/// Returns what a medium emits, as a luminance; nothing if it emits none.
std::string glow_text(const Medium& medium) {
    if (!emits(medium)) return "";
    if (medium.glow->heat) return "; emits by its temperature";
    const char* const varies = medium.glow->factor ? ", times a factor that varies" : "";
    return fmt::format("; emits {:.3g} where it is thick{}", medium.glow->radiance.luminance(),
                       varies);
}

/// Mean free paths, of all wavelengths alike, where a medium is densest.
void print_media(const Scene& scene) {
    const std::vector<Medium>& media = scene.media().all;
    for (std::size_t i = 1; i < media.size(); ++i) {
        const float density = media[i].density ? greatest(*media[i].density) : 1;
        const auto path = [&](const Spectrum& coefficient) {
            const float of_length = coefficient.luminance() * density;
            return of_length > 0 ? fmt::format("{:.3g}", 1 / of_length) : std::string("infinity");
        };
        const std::string varies =
            media[i].density ? fmt::format(" where it is densest; its mean is {:.3g} of that",
                                           mean(*media[i].density) / density)
                             : "";
        fmt::print("medium      {}: mean free path {} to scattering, {} to absorption{}{}\n", i,
                   path(media[i].scattering), path(media[i].absorption), varies,
                   glow_text(media[i]));
    }
}

/// What the file says of lights, one by one: the numbers that --light-group takes.
void list_lights(const Scene& scene) {
    const std::vector<LightStatement>& statements = scene.light_statements();
    std::vector<double> shares(statements.size());
    for (std::size_t i = 0; i < scene.lights().size(); ++i)
        if (const std::uint32_t statement = scene.stated_in()[i]; statement != kNone)
            shares[statement] += scene.light_choice().probability(i);
    for (std::size_t i = 0; i < statements.size(); ++i)
        fmt::print("light       {} {} at {} ({:.3g}% of the photons)\n", i + 1, statements[i].what,
                   statements[i].where.text(), 100 * shares[i]);
}

/// How each word of the scene is treated; of what is not exact, also what is done instead.
void print_words(const std::vector<UsedWord>& words) {
    for (const UsedWord& used : words) {
        const WordRow* row = find_word(used.directive, used.word);
        if (row == nullptr) continue;  // all are known: a test
        const bool plain = used.directive == "Directive";
        const std::string name =
            plain ? used.word : fmt::format("{} \"{}\"", used.directive, used.word);
        const bool exact = row->treatment == Treatment::exact || row->treatment == Treatment::ours;
        fmt::print("word        {:<12} {} x {}{}{}\n", name_of(row->treatment), used.count, name,
                   exact ? "" : ": ", exact ? "" : row->read_as);
    }
}

/// At default settings. Reading the scene may have taken more than rendering it will.
void print_memory(const Scene& scene) {
    const std::uint64_t of_scene = memory_in_use();
    const MemoryEstimate render = render_bytes({scene, {}, {}});
    const auto text = [&](std::uint64_t bytes) {
        return memory_text(std::max(most_memory_in_use(), of_scene + bytes));
    };
    fmt::print(
        "memory      about {} to render, {} of them for the scene; up to {} if noise asks for "
        "many camera paths a pixel\n",
        text(render.usual), memory_text(of_scene), text(render.most));
}

void print_vocabulary() {
    for (const std::string_view directive : vocabulary_directives())
        fmt::print("{}\n", vocabulary_table(directive));
}

}  // namespace

int run_info(const InfoOptions& options) {
    if (options.words) {
        print_vocabulary();
        return 0;
    }
    try_threads();
    SceneDescription description = load_scene(options.scene, options.scene_request);
    std::size_t in_objects = 0;
    for (const auto& object : description.objects) in_objects += object.size();
    const std::size_t shapes = description.shapes.size();
    const std::size_t instances = description.instances.size();
    const std::vector<std::string> files = description.files;
    const std::vector<UsedWord> words = description.words;
    const Scene scene(std::move(description));
    fmt::print("scene       {}\n", options.scene);
    for (const std::string& file : files) fmt::print("file        {}\n", file);
    fmt::print("shapes      {} in the world, {} in objects, {} instances\n", shapes, in_objects,
               instances);
    fmt::print("triangles   {} (instances counted each)\n", scene.geometry().triangle_count());
    std::map<std::string, int> materials;
    for (const Material& material : scene.materials()) ++materials[std::string(name_of(material))];
    for (const auto& [name, count] : materials) fmt::print("materials   {} {}\n", count, name);
    print_media(scene);
    print_lights(scene);
    if (options.lights) list_lights(scene);
    const SceneSphere& sphere = scene.sphere();
    fmt::print("bounds      centre {:.6g} {:.6g} {:.6g}, radius {:.6g}\n", sphere.center.x,
               sphere.center.y, sphere.center.z, sphere.radius);
    const PixelWindow window = window_of(scene.film());
    fmt::print("film        {} x {}, rendered {} x {}\n", scene.film().resolution.x,
               scene.film().resolution.y, window.width(), window.height());
    print_memory(scene);
    if (scene.hints().integrator == "sppm")  // any other one is told by a warning
        fmt::print("integrator  \"sppm\", as here\n");
    print_words(words);
    for (const auto& warning : scene.warnings().entries()) fmt::print("{}\n", warning.line());
    return 0;
}

}  // namespace sunfleck::engine
