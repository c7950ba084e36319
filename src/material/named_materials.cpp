// The table of names, and what each makes.
#include "material/named_materials.h"

#include "core/edit_distance.h"
#include "core/named_rows.h"
#include "core/printable.h"
#include "core/small_letters.h"
#include "core/text_cursor.h"
#include "image/srgb.h"
#include "material/substances.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace sunfleck::engine {
namespace {

using F = MaterialFamily;

constexpr std::string_view kSchott = "Schott's catalogue";
constexpr std::string_view kPbrt = "pbrt-v4's tables (SOPRA, Luxpop)";
constexpr std::string_view kJohnson = "Johnson and Christy 1974";
constexpr std::string_view kSultanova = "Sultanova et al. 2009";
constexpr std::string_view kOwn = "chosen by eye";

constexpr auto kNames = std::to_array<MaterialName>({
    {"bk7", F::glass, "the usual optical glass", kSchott},
    {"soda-lime", F::glass, "window and bottle glass, faintly green", "Rubin 1985"},
    {"baf10", F::glass, "barium flint glass", kSchott},
    {"fk51a", F::glass, "fluor crown glass of low dispersion", kSchott},
    {"f2", F::glass, "flint glass, close to crystal glass", kSchott},
    {"sf5", F::glass, "dense flint glass", kSchott},
    {"sf10", F::glass, "denser flint glass", kSchott},
    {"sf11", F::glass, "flint glass of high dispersion, for prisms", kSchott},
    {"lasf9", F::glass, "lanthanum flint glass of high index", kSchott},
    {"fused-silica", F::glass, "quartz glass", "Malitson 1965"},
    {"fluorite", F::glass, "calcium fluoride", "Malitson 1963"},
    {"sapphire", F::glass, "without double refraction: its ordinary ray",
     "Malitson and Dodge 1972"},
    {"diamond", F::glass, "clear", "Peter 1923"},
    {"water", F::glass, "pure, blue over metres", "Daimon and Masumura 2007; Hale and Querry 1973"},
    {"pmma", F::glass, "acrylic, Plexiglas", kSultanova},
    {"polycarbonate", F::glass, "clear", kSultanova},
    {"polystyrene", F::glass, "clear", kSultanova},
    {"aluminium", F::metal, "", kPbrt},
    {"silver", F::metal, "", kPbrt},
    {"gold", F::metal, "", kPbrt},
    {"copper", F::metal, "", kPbrt},
    {"brass", F::metal, "", kPbrt},
    {"iron", F::metal, "also for steel", kJohnson},
    {"chromium", F::metal, "", kJohnson},
    {"titanium", F::metal, "", kJohnson},
    {"mirror", F::metal, "reflects 95% of all wavelengths", kOwn},
    {"plastic", F::plastic, "light grey, half glossy", kOwn},
    {"rubber", F::plastic, "nearly black, of a dull sheen", kOwn},
    {"lacquer", F::plastic, "grey paint under a smooth clear coat", kOwn},
    {"matt", F::matt, "light grey", kOwn},
    {"plaster", F::matt, "warm white", kOwn},
    {"paper", F::matt, "white", kOwn},
    {"clay", F::matt, "terracotta", kOwn},
});

struct Alias {
    std::string_view name;
    std::string_view means;
};

constexpr auto kAliases = std::to_array<Alias>({{"aluminum", "aluminium"},
                                                {"acrylic", "pmma"},
                                                {"plexiglas", "pmma"},
                                                {"chrome", "chromium"},
                                                {"crystal", "f2"},
                                                {"n-bk7", "bk7"},
                                                {"n-sf11", "sf11"},
                                                {"quartz", "fused-silica"},
                                                {"steel", "iron"},
                                                {"window", "soda-lime"}});

struct Colour {
    std::string_view name;
    Vec3 rgb;  // linear sRGB
};

const std::array<Colour, 9>& colours() {
    static const std::array<Colour, 9> all = {{{"white", {0.8F, 0.8F, 0.8F}},
                                               {"grey", {0.3F, 0.3F, 0.3F}},
                                               {"black", {0.02F, 0.02F, 0.02F}},
                                               {"red", {0.52F, 0.03F, 0.02F}},
                                               {"orange", {0.75F, 0.2F, 0.02F}},
                                               {"yellow", {0.78F, 0.52F, 0.03F}},
                                               {"green", {0.05F, 0.3F, 0.08F}},
                                               {"blue", {0.03F, 0.1F, 0.45F}},
                                               {"brown", {0.2F, 0.09F, 0.04F}}}};
    return all;
}

/// Returns the words between colons.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : small_letters(std::string(text)))
        if (c == ':')
            words.emplace_back();
        else
            words.back() += c == '_' || c == ' ' ? '-' : c;
    return words;
}

/// Returns the row of a name, its alias or its family, or null.
const MaterialName* row_of(std::string_view name) {
    if (const Alias* const alias = row_named(kAliases, name)) name = alias->means;
    if (const MaterialName* const row = row_named(kNames, name)) return row;
    const auto* const first =
        std::find_if(kNames.begin(), kNames.end(),
                     [&](const MaterialName& row) { return name_of(row.family) == name; });
    return first == kNames.end() ? nullptr : first;
}

/// Returns `use "a", "b" or "c"` of the nearest names.
std::string use_nearest(std::string_view name) {
    constexpr std::size_t kShown = 3;
    constexpr std::size_t kLongest = 60;
    std::vector<std::string_view> names;
    names.reserve(kNames.size());
    for (const MaterialName& row : kNames) names.push_back(row.name);
    const std::string_view given = name.substr(0, kLongest);
    std::stable_sort(names.begin(), names.end(), [&](std::string_view a, std::string_view b) {
        return edit_distance(a, given) < edit_distance(b, given);
    });
    std::string text = "use ";
    for (std::size_t i = 0; i < kShown; ++i)
        text += std::string(i == 0 ? "" : i + 1 == kShown ? " or " : ", ") + in_quotes(names[i]);
    return text + ", or another of docs/reference/materials.md";
}

std::optional<Vec3> colour_of(std::string_view word) {
    const auto& all = colours();
    if (const Colour* const colour = row_named(all, word)) return colour->rgb;
    if (word.size() != 7 || word[0] != '#') return {};
    Vec3 rgb;
    for (int c = 0; c < 3; ++c) {
        unsigned byte = 0;
        const char* const begin = word.data() + 1 + 2 * c;
        const auto [end, fault] = std::from_chars(begin, begin + 2, byte, 16);
        if (fault != std::errc() || end != begin + 2) return {};
        rgb[c] = srgb_decode(static_cast<float>(byte) / 255);
    }
    return rgb;
}

MaterialWishes wishes_of(const MaterialName& row, std::span<const std::string> words,
                         const SourceLocation& where) {
    MaterialWishes wishes;
    const std::string name(row.name);
    for (const std::string& word : words) {
        const auto number = number_of(word);
        const auto colour = colour_of(word);
        if (!number && !colour)
            throw Error(where, in_quotes(word) + " is neither a roughness nor a colour",
                        "write a number from 0 to 1, a colour such as red, or #rrggbb");
        if (number && !(*number >= 0 && *number <= 1))
            throw Error(where, "a roughness of " + word, "give a number from 0 to 1");
        if (number && row.family == F::matt)
            throw Error(where, name + " has no roughness", "leave it out, or use plastic");
        if (colour && (row.family == F::glass || row.family == F::metal))
            throw Error(where, name + " has a colour of its own", "leave it out, or use plastic");
        if (number ? wishes.roughness.has_value() : wishes.colour.has_value())
            throw Error(where, number ? "two numbers for the roughness" : "two colours",
                        "give one");
        if (number) wishes.roughness = static_cast<float>(*number);
        if (colour) wishes.colour = colour;
    }
    return wishes;
}

}  // namespace

std::string_view name_of(MaterialFamily family) {
    switch (family) {
        case F::glass:
            return "glass";
        case F::metal:
            return "metal";
        case F::plastic:
            return "plastic";
        case F::matt:
            return "matt";
    }
    return "";
}

std::span<const MaterialName> material_names() {
    return kNames;
}

std::span<const std::string_view> colour_names() {
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> names;
        names.reserve(colours().size());
        for (const Colour& colour : colours()) names.push_back(colour.name);
        return names;
    }();
    return all;
}

NamedMaterial named_material(std::string_view text, const SourceLocation& where) {
    const std::vector<std::string> words = words_of(text);
    const MaterialName* row = row_of(words[0]);
    std::size_t read = 1;
    // A family before a name says nothing more, but must fit.
    if (words.size() > 1)
        if (const MaterialName* const second = row_of(words[1])) {
            const bool is_family = row != nullptr && name_of(row->family) == words[0];
            if (!is_family)
                throw Error(where, in_quotes(words[0]) + " is no family of materials",
                            "use glass, metal, plastic or matt before the name, or nothing");
            if (second->family != row->family)
                throw Error(where, in_quotes(words[1]) + " is no " + words[0],
                            "write " + std::string(name_of(second->family)) + ":" + words[1]);
            row = second;
            read = 2;
        }
    if (row == nullptr ||
        (words.size() > 1 && read == 1 && !number_of(words[1]) && !colour_of(words[1]) &&
         !words[1].starts_with('#') && name_of(row->family) == words[0]))
        throw Error(where,
                    "there is no material " + in_quotes(row == nullptr ? words[0] : words[1]),
                    use_nearest(row == nullptr ? words[0] : words[1]));
    const MaterialWishes wishes = wishes_of(*row, std::span(words).subspan(read), where);
    return material_of(*row, wishes);
}

}  // namespace sunfleck::engine
