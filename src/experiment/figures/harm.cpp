// Figure 9: scenes where nothing is to be gained.
#include "experiment/figures/common.h"

namespace sunfleck {
namespace {

const std::vector<std::string> kScenes = {"cornell", "box"};

std::vector<Method> methods() {
    return {sampler_method("random"), sampler_method("paper"), sampler_method("adaptive")};
}

Section fig9_section(const Results& results) {
    Section section;
    for (const std::string& scene : kScenes) {
        for (const char* name : {"paper", "adaptive"})
            section.findings.push_back(
                ratio_sentence(results, scene, sampler_method(name), sampler_method("random")));
        section.pictures.push_back(picture_row(results, "fig9", scene, methods()));
    }
    section.tables.push_back(error_table(results, "fig9-errors", kScenes, methods()));
    return section;
}

}  // namespace

Figure fig9() {
    return {"fig9",
            "Figure 9: where most paths are visible",
            "There is no benefit where most photons are visible (ratio below 10), and no visible "
            "harm either.",
            kScenes,
            [](const RunSettings& s) { return seed_cells(s, kScenes, methods()); },
            fig9_section};
}

}  // namespace sunfleck
