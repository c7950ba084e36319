// Figure 9: scenes where nothing is to be gained.
#include "experiment/figures/common.h"

#include <fmt/format.h>

namespace sunfleck::engine {
namespace {

const std::vector<std::string> kScenes = {"cornell", "box"};

std::vector<Method> unharmed_methods() {
    return {sampler_method("random"), sampler_method("paper"), sampler_method("adaptive")};
}

/// The chain takes over a visible uniform path, and else its mutation if that is visible. Where
/// mutations are as good as new paths, it goes on with probability p = v (2 - v), its states are
/// worth p / (2 - p) independent ones, and it traces 2 - v paths an iteration.
std::string least_cost(const Results& results, const std::string& scene) {
    const double v = results.facts({scene, sampler_method("paper")}).visible_fraction;
    return fmt::format(
        "In {} {:.0f}% of uniform paths are visible: at equal radii and equal time a ray paper "
        "would stand at 1 + (1 - v)^2 = {:.2f} over random even if its mutations were independent "
        "paths; its local radii and the keeping of its chain come on top.",
        scene, 100 * v, 1 + (1 - v) * (1 - v));
}

Section fig9_section(const Results& results) {
    Section section;
    for (const std::string& scene : kScenes) {
        for (const char* name : {"paper", "adaptive"})
            section.findings.push_back(
                ratio_sentence(results, scene, sampler_method(name), sampler_method("random")));
        section.findings.push_back(least_cost(results, scene));
        section.rows.push_back(picture_row(results, "fig9", scene, unharmed_methods()));
    }
    section.tables.push_back(error_table(results, "fig9-errors", kScenes, unharmed_methods()));
    return section;
}

}  // namespace

Figure fig9() {
    return {"fig9",
            "Figure 9: where most paths are visible",
            "There is no benefit where most photons are visible (ratio below 10), and no visible "
            "harm either.",
            kScenes,
            [](const RunSettings& s) { return seed_cells(s, kScenes, unharmed_methods()); },
            fig9_section};
}

}  // namespace sunfleck::engine
