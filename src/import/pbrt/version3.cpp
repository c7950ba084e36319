// Tables of what pbrt-v4 renamed or removed.
//
// Source: the users' guides of pbrt-v3 and pbrt-v4.
#include "import/pbrt/version3.h"

#include "import/pbrt/words.h"

#include <algorithm>
#include <array>
#include <span>

namespace sunfleck::engine {
namespace {

constexpr std::array<std::string_view, 5> kDirectivesOfV3 = {
    "WorldEnd", "SurfaceIntegrator", "VolumeIntegrator", "Renderer", "Volume"};
constexpr std::array<std::string_view, 2> kTypesOfV3 = {"color", "xyz"};
constexpr std::array<std::string_view, 3> kParametersOfV3 = {"mapname", "namedmaterial1",
                                                             "namedmaterial2"};

struct WordOfV3 {
    std::string_view directive;
    std::string_view type;
};

constexpr auto kWordsOfV3 = std::to_array<WordOfV3>({
    {"Film", "image"},
    {"Camera", "environment"},
    {"Sampler", "02sequence"},
    {"Sampler", "lowdiscrepancy"},
    {"Sampler", "maxmindist"},
    {"Sampler", "random"},
    {"Sampler", "bestcandidate"},
    {"Sampler", "adaptive"},
    {"Integrator", "directlighting"},
    {"Integrator", "whitted"},
    {"Accelerator", "grid"},
    {"Material", "matte"},
    {"Material", "plastic"},
    {"Material", "uber"},
    {"Material", "glass"},
    {"Material", "mirror"},
    {"Material", "metal"},
    {"Material", "shinymetal"},
    {"Material", "substrate"},
    {"Material", "translucent"},
    {"Material", "disney"},
    {"Material", "fourier"},
    {"Material", "kdsubsurface"},
    {"Texture", "uv"},
    {"Shape", "cone"},
    {"Shape", "paraboloid"},
    {"Shape", "hyperboloid"},
    {"Shape", "heightfield"},
    {"Shape", "nurbs"},
    {"AreaLightSource", "area"},
    {"MakeNamedMedium", "heterogeneous"},
});

bool is_in(std::span<const std::string_view> words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

bool is_directive_of_v3(std::string_view word) {
    return is_in(kDirectivesOfV3, word);
}

bool is_parameter_type_of_v3(std::string_view word) {
    return is_in(kTypesOfV3, word);
}

bool is_parameter_of_v3(std::string_view name) {
    return is_in(kParametersOfV3, name);
}

void check_not_of_v3(std::string_view directive, std::string_view type,
                     const SourceLocation& where) {
    const bool found = std::any_of(kWordsOfV3.begin(), kWordsOfV3.end(), [&](const WordOfV3& word) {
        return word.type == type && word.directive == directive;
    });
    if (found) refuse_v3(std::string(directive) + " " + in_quotes(type), where);
}

void refuse_v3(const std::string& what, const SourceLocation& where) {
    throw Error(where, what + " belongs to pbrt-v3, but pbrt-v4 is read",
                "use the words of pbrt-v4, which converts a scene file: pbrt --upgrade OLD.pbrt > "
                "NEW.pbrt");
}

}  // namespace sunfleck::engine
