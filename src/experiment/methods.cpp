// Flags of each method, and the choice of references.
#include "experiment/methods.h"

#include <array>
#include <string_view>

namespace sunfleck::engine {
namespace {

struct ReferenceRow {
    std::string_view scene;
    std::string_view method;
};

// Path tracing where it finds all light, uniform photons where enough of them are seen; the rest
// has none but the sampler under test, many times longer.
constexpr std::array<ReferenceRow, 9> kReferences = {{
    {"cornell", "path"},
    {"statue-far", "path"},
    {"statue-near", "path"},
    {"box", "uniform"},
    {"cognac-0", "uniform"},
    {"cornell-door", "uniform"},
    {"room", "uniform"},
    {"two-windows", "uniform"},
    {"magnifier", "uniform"},
}};

}  // namespace

Method sampler_method(const std::string& name) {
    if (name == "paper") return paper_method("paper", {});
    return {name,
            {"--photon-sampler", name, "--direct", "photons", "--alpha", "0.7",
             "--photons-per-pass", "200000", "--radius-pixels", "2", "--indirect-radius", "1"}};
}

std::vector<Method> sampler_methods() {
    return {sampler_method("random"), sampler_method("uniform"), sampler_method("paper"),
            sampler_method("adaptive")};
}

Method default_method() {
    return {"default", {}};
}

Method integrator_method(const std::string& name) {
    return {name, {"--integrator", name}};
}

Method paper_method(const std::string& name, const std::vector<std::string>& flags) {
    Method method{name, {"--mode", "paper"}};
    method.flags.insert(method.flags.end(), flags.begin(), flags.end());
    return method;
}

Cell reference_cell(const std::string& scene, const RunSettings& settings) {
    Method method = default_method();
    for (const ReferenceRow& row : kReferences) {
        if (row.scene != scene) continue;
        const std::string name(row.method);
        method =
            name == "path" ? integrator_method(name) : Method{name, {"--photon-sampler", name}};
    }
    method.name = "reference-" + (method.flags.empty() ? "adaptive" : method.flags.back());
    if (method.name != "reference-path")  // no more bias than samplers under test
        method.flags.insert(method.flags.end(), {"--indirect-radius", "1"});
    return {scene, method, 1000, settings.reference_budget};
}

}  // namespace sunfleck::engine
