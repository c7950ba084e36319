// The rows of the flags of every way of rendering.
#include "flags/flag_tables.h"
#include "image/output_transform.h"

#include <sstream>

namespace sunfleck::engine {
namespace {

const char* const kIndependentPasses = "needs passes that do not build on one another";
const char* const kOtherSampler = "leave it out, or use another sampler than paper";

Exposure read_exposure(const std::string& text, const std::string& flag) {
    if (text == "auto") return {.is_automatic = true};
    return {.stops = read_number(text, flag, -kMostExposure, kMostExposure)};
}

FlagValue aov_list() {
    FlagValue value = one_of({}, [](RenderRequest& r, const std::string& text) {
        std::istringstream words(text);
        for (std::string word; std::getline(words, word, ',');)
            for (const AovRow& row : kAovs)
                if (row.name == word) r.settings.aovs.at(static_cast<std::size_t>(row.aov)) = true;
    });
    value.form = "NAME,...";
    value.is_list = true;
    for (const AovRow& row : kAovs)
        if (!row.name.empty()) value.choices.push_back({std::string(row.name)});
    return value;
}

std::vector<RenderFlag> frame_flags() {
    return {
        {.name = "--resolution",
         .value =
             value_of("WxH", read_size, [](auto& r, const auto& size) { r.resolution = size; }),
         .help = "Size in pixels; the view keeps the extent of its shorter axis",
         .default_value = "the scene's"},
        {.name = "--crop",
         .value = value_of("X0,X1,Y0,Y1", read_crop,
                           [](auto& r, const auto& pixels) { r.crop = pixels; }),
         .help = "Render these pixels alone",
         .default_value = "the scene's"},
        {.name = "--cropwindow",
         .value = value_of("X0,X1,Y0,Y1", read_crop_window,
                           [](auto& r, const auto& window) { r.crop_window = window; }),
         .help = "The same as fractions of the picture, from 0 to 1, as pbrt has them",
         .needs = {{.flag = "--crop"}}},
        {.name = "--exposure",
         .value = value_of("STOPS|auto", read_exposure,
                           [](auto& r, const auto& exposure) { r.exposure = exposure; }),
         .help =
             "Stops (-100 to 100), for .png and .jpg; auto: the middle of the picture becomes a "
             "middle grey",
         .default_value = "0, but auto for scenes other than pbrt's"},
    };
}

std::vector<RenderFlag> light_flags() {
    return {
        {.name = "--aovs",
         .value = aov_list(),
         .help = "AOVs, as EXR layers",
         .needs = {needs_photon_mapping()}},
        {.name = "--light-group",
         .value = {.form = "NAME=LIGHTS|each",
                   .repeats = true,
                   .read = [](RenderRequest& r, const std::string& text,
                              const std::string&) { add_light_group(text, r.light_groups); }},
         .help = "Light group NAME: an EXR layer for some lights alone, by their numbers in "
                 "sunfleck info --lights: NAME=1,3-5; may be repeated. each: a group per light, "
                 "light1, light2 ...",
         .needs = {needs_photon_mapping(),
                   refused_by_paper("the sampler paper sums the light of all lights in one",
                                    "use another sampler")}},
        {.name = "--extrapolate",
         .value = one_of(
             {{"off"},
              {"on",
               "subtract the bias of the gather discs, as it shows in how light "
               "falls with their radius; pictures have 2 to 3.5 times the noise"}},
             [](auto& r, const auto& name) { r.stop.error_terms.extrapolated = name == "on"; }),
         .help = "Bias of the picture",
         .needs = {needs_photon_mapping(), refused_by_paper(kIndependentPasses, kOtherSampler)}},
    };
}

}  // namespace

std::vector<RenderFlag> end_flags() {
    return {
        {.name = "--target-error",
         .value = value_of("X%", read_share,
                           [](auto& r, const auto& error) { r.stop.target_error = error; }),
         .help = "End when the noise of 95% of the blocks and the bias together come to this "
                 "relative error; of blocks brighter than a tenth of the picture",
         .default_value = "2%, or after 10m, where no end is given",
         .needs = {refused_by_paper("the sampler paper has no error bars",
                                    "use --passes or --time")}},
        {.name = "--target-error-of",
         .value =
             one_of({{"all", "noise, and the bias of the gather discs"}, {"noise"}},
                    [](auto& r, const auto& name) { r.stop.error_terms.bias = name == "all"; }),
         .help = "What --target-error counts",
         .needs = {needs_photon_mapping(), refused_by_paper(kIndependentPasses, kOtherSampler)}},
        {.name = "--objective",
         .value = one_of(choices_of(kObjectives),
                         [](auto& r, const auto& name) {
                             r.settings.objective =
                                 row_named(kObjectives, name)->value;  // a choice
                             r.stop.error_terms.objective = r.settings.objective;
                         }),
         .help = "What the picture is judged by: by --target-error, and where the sampler adaptive "
                 "spends its paths",
         .needs = {refused_by_paper("is nothing that the sampler paper knows")}},
        {.name = "--time",
         .value = value_of("TIME", read_duration,
                           [](auto& r, const auto& seconds) { r.stop.seconds = seconds; }),
         .help = "End after this time of rendering: 60s, 5m, 2h. Reading the scene does not "
                 "count; all rendering before --resume does"},
        {.name = "--cpu-time",
         .value = value_of("TIME", read_duration,
                           [](auto& r, const auto& seconds) { r.stop.cpu_seconds = seconds; }),
         .help = "The same of processor time, all threads together: for comparisons"},
        {.name = "--passes",
         .alias = "--spp",
         .value =
             whole(1, 1 << 30,
                   [](auto& r, const auto& n) { r.stop.end_pass = static_cast<std::uint32_t>(n); }),
         .help = "End after this many passes"},
        {.name = "--pass-range",
         .value = value_of("A:B", read_pass_range,
                           [](auto& r, const auto& range) {
                               r.stop.first_pass = range[0];
                               r.stop.end_pass = range[1];
                           }),
         .help = "Render passes A to B - 1 alone, for sunfleck merge to add up",
         .needs = {{.flag = "--passes"},
                   refused_by_paper("passes of the sampler paper build on those before",
                                    "use --passes")}},
    };
}

std::vector<RenderFlag> picture_flags() {
    std::vector<RenderFlag> rows = frame_flags();
    for (RenderFlag& row : light_flags()) rows.push_back(std::move(row));
    return rows;
}

std::vector<RenderFlag> transport_flags() {
    return {
        {.name = "--max-depth",
         .value =
             whole(1, 10000, [](auto& r, const auto& n) { r.max_depth = static_cast<int>(n); }),
         .help = "Scattering events on a path, camera and light subpaths together",
         .default_value = "the scene's, or 64"},
        {.name = "--energy-compensation",
         .value = one_of(
             {{"off"},
              {"on", "rough metals and glass give back what is lost between their facets"}},
             [](auto& r, const auto& name) { r.settings.energy_compensation = name == "on"; }),
         .help = "Multiple scattering between microfacets"},
    };
}

std::vector<RenderFlag> run_flags() {
    return {
        {.name = "--seed",
         .value =
             value_of("N", read_seed, [](auto& r, const auto& seed) { r.settings.seed = seed; }),
         .help = "Random seed",
         .default_value = "0"},
        {.name = "--isa",
         .value = one_of({{"avx2", "the same bytes on every such machine"},
                          {"native", "all that this machine has; bytes may differ"}},
                         [](auto& r, const auto& name) { r.isa = name; }),
         .help = "Instructions that rays are traced by"},
    };
}

}  // namespace sunfleck::engine
