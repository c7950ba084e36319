// Figures 1, 10, 12 and 13: pictures after equal time, and their errors.
#include "experiment/figures/common.h"

namespace sunfleck::engine {
namespace {

Figure equal_time(const std::string& name, const std::string& title, const std::string& claim,
                  const std::vector<std::string>& scenes, const std::vector<Method>& methods) {
    const auto cells = [=](const RunSettings& settings) {
        return seed_cells(settings, scenes, methods);
    };
    const auto section = [=](const Results& results) {
        Section shown;
        shown.tables.push_back(error_table(results, name + "-errors", scenes, methods));
        for (const std::string& scene : scenes)
            shown.rows.push_back(picture_row(results, name, scene, methods));
        return shown;
    };
    return {name, title, claim, scenes, cells, section};
}

const std::vector<Method>& three() {
    static const std::vector<Method> methods = {sampler_method("random"), sampler_method("paper"),
                                                sampler_method("adaptive")};
    return methods;
}

}  // namespace

Figure fig1() {
    return equal_time("fig1", "Figure 1: closing in on a caustic",
                      "The closer the view, the fewer uniform photons it sees; the paper's method "
                      "keeps its noise low in the same time, whatever the view.",
                      {"cognac-0", "cognac-1", "cognac-2", "cognac-3", "cognac-4"}, three());
}

Figure fig10() {
    return equal_time("fig10", "Figure 10: a glossy statue",
                      "Far away the noise is that of the glossy brdf, which visibility does not "
                      "address; close up there still is a visible gain.",
                      {"statue-far", "statue-near"}, three());
}

Figure fig12() {
    std::vector<Method> methods = three();
    methods.push_back(integrator_method("mlt"));
    return equal_time("fig12", "Figure 12: light through a door ajar",
                      "Photon paths are mutated from the light on, so light that comes through a "
                      "small gap is found as Metropolis light transport finds it.",
                      {"cornell-door"}, methods);
}

Figure fig13() {
    std::vector<Method> methods = three();
    for (const char* name : {"path", "bdpt", "mlt"}) methods.push_back(integrator_method(name));
    Figure figure =
        equal_time("fig13", "Figure 13: light seen through glass that fell through glass",
                   "Specular-diffuse-specular light is beyond path tracing and bidirectional path "
                   "tracing, and hard for Metropolis light transport; photon mapping finds it, and "
                   "the paper's sampling keeps that robustness.",
                   {"magnifier"}, methods);
    const auto plain = figure.section;
    figure.section = [=](const Results& results) {
        Section section = plain(results);
        section.charts.push_back(error_chart(results, "fig13", "magnifier", methods));
        return section;
    };
    return figure;
}

}  // namespace sunfleck::engine
