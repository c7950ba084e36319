// The rows of the flags about the method.
#include "core/named_rows.h"
#include "flags/flag_tables.h"
#include "photon_samplers/samplers.h"

namespace sunfleck::engine {
namespace {

/// Sets the sampler, and with `paper` all that belongs to it.
void set_sampler(RenderRequest& request, const std::string& name) {
    request.settings.photon.sampler =
        row_named(kPhotonSamplers, name)->sampler;  // one of the choices
    if (request.settings.photon.sampler == PhotonSampler::paper) use_paper_mode(request.settings);
}

std::vector<RenderFlag> estimator_flags() {
    return {
        {.name = "--integrator",
         .value = one_of(choices_of(kIntegrators),
                         [](auto& r, const auto& name) {
                             r.settings.integrator =
                                 row_named(kIntegrators, name)->value;  // a choice
                         }),
         .help = "What renders: the photon mapper, or a reference to compare it with"},
        {.name = "--photon-sampler",
         .value = one_of(choices_of(kPhotonSamplers), set_sampler),
         .help = "Where photon paths come from",
         .needs = {needs_photon_mapping()}},
        {.name = "--mode",
         .value = one_of({{"paper", "the same as --photon-sampler paper"}}, set_sampler),
         .help = "The paper's algorithm",
         .needs = {needs_photon_mapping(),
                   {.flag = "--photon-sampler",
                    .values = {"paper"},
                    .why = "is the sampler paper, and --photon-sampler names another",
                    .mend = "leave one of them out"}}},
        {.name = "--direct",
         .value = one_of({{"sampled", "by sampling the lights"}, {"photons", "by photons, too"}},
                         [](auto& r, const auto& name) {
                             r.settings.transport.direct =
                                 name == "photons" ? DirectLight::photons : DirectLight::sampled;
                         }),
         .help = "How direct light is estimated; with the sampler paper by photons",
         .needs = {needs_photon_mapping(),
                   of_value("sampled", refused_by_paper("is photons with the sampler paper"))}},
        {.name = "--indirect",
         .value = one_of(choices_of(kIndirectLights),
                         [](auto& r, const auto& name) {
                             r.settings.transport.indirect =
                                 row_named(kIndirectLights, name)->value;  // a choice
                         }),
         .help = "Who brings light from one diffuse surface to another, where a lamp lights the "
                 "first",
         .needs = {needs_photon_mapping(),
                   {.flag = "--direct", .values = {"sampled"}, .why = "photons estimate all light"},
                   of_value("sampled", refused_by_paper("photons estimate all light"))}},
        {.name = "--ris",
         .value = one_of({{"auto", "resampled importance sampling of several candidates"},
                          {"off", "one light sample per vertex"}},
                         [](auto& r, const auto& name) { r.settings.camera.ris = name == "auto"; }),
         .help = "Direct light by sampling",
         .needs = {needs_photon_mapping(),
                   {.flag = "--direct",
                    .values = {"sampled"},
                    .why = "photons estimate direct light: there are no light samples"},
                   refused_by_paper("photons estimate direct light: there are no light samples")}},
    };
}

std::vector<RenderFlag> gathering_flags() {
    return {
        {.name = "--photons-per-pass",
         .value = whole(1, 1 << 30,
                        [](auto& r, const auto& n) {
                            r.settings.photon.paths_per_pass = static_cast<std::uint32_t>(n);
                        }),
         .help = "Photon paths per pass",
         .default_value = "200000 or 2 a pixel, the larger; with the sampler paper 200000",
         .needs = {{.flag = "--integrator", .values = {"sppm", "light"}}}},
        {.name = "--radius-pixels",
         .value =
             number(1e-3, 1e3, [](auto& r, const auto& x) { r.settings.camera.radius_pixels = x; }),
         .help = "First gather radius, in pixel footprints",
         .default_value = "2, less in pictures of fewer than 512 pixels a side; with the sampler "
                          "paper 2",
         .needs = {needs_photon_mapping()}},
        {.name = "--radius",
         .value = number(1e-30, 1e30, [](auto& r, const auto& x) { r.settings.camera.radius = x; }),
         .help = "First gather radius in scene units, in place of --radius-pixels",
         .needs = {needs_photon_mapping(), {.flag = "--radius-pixels"}}},
        {.name = "--indirect-radius",
         .value =
             number(1, 100, [](auto& r, const auto& x) { r.settings.camera.indirect_radius = x; }),
         .help = "Radius for photons that a rough surface has scattered, over that for others",
         .default_value = "2 to 3.1, more in pictures of more than 512 pixels a side; less where a "
                          "radius is given; with the sampler paper 1",
         .needs = {needs_photon_mapping(), refused_by_paper("is 1 with the sampler paper")}},
        {.name = "--edges",
         .value =
             one_of({{"auto", "light is divided by the share of the disc that lies on a surface"},
                     {"off", "discs that reach over an edge lose light"}},
                    [](auto& r, const auto& name) { r.settings.camera.edges = name == "auto"; }),
         .help = "Gather discs at the edges of surfaces; with the sampler paper off",
         .needs = {needs_photon_mapping(),
                   of_value("auto", refused_by_paper("is off with the sampler paper"))}},
        {.name = "--alpha",
         .value = number(1e-6, 1 - 1e-6, [](auto& r, const auto& x) { r.settings.alpha = x; }),
         .help = "How slowly radii shrink: areas go with the number of passes to the power of "
                 "alpha - 1",
         .default_value = "2/3; with the sampler paper 0.7",
         .needs = {needs_photon_mapping()}},
    };
}

}  // namespace

std::vector<RenderFlag> method_flags() {
    std::vector<RenderFlag> rows = estimator_flags();
    for (RenderFlag& row : gathering_flags()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sunfleck::engine
