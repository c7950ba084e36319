// Directives before WorldBegin: camera, picture, integrator, options.
#include "import/pbrt/directives.h"
#include "import/pbrt/numbers.h"
#include "import/pbrt/parameter_parser.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <cctype>

namespace sunfleck::engine {
namespace {

void camera(Reading& reading, TokenStream& tokens, const Token& keyword) {
    reading.options.camera = read_statement(tokens, keyword);
    reading.options.camera_medium = reading.state.outside_medium;
    reading.options.camera_from_world = reading.state.matrix;
    const Motion& from_world = reading.state.matrix;
    reading.coordinate_systems["camera"] = {from_world[0].inverse(), from_world[1].inverse()};
}

void film(Reading& reading, TokenStream& tokens, const Token& keyword) {
    reading.options.film = read_statement(tokens, keyword);
    if (reading.state.colour_space != ColourSpace::srgb)
        reading.log.warn(
            keyword.where(),
            "the picture is written in linear sRGB, not in the colour space given before");
}

void filter(Reading& reading, TokenStream& tokens, const Token& keyword) {
    reading.options.filter = read_statement(tokens, keyword);
}

void sampler(Reading& reading, TokenStream& tokens, const Token& keyword) {
    reading.options.sampler = read_statement(tokens, keyword);
}

void integrator(Reading& reading, TokenStream& tokens, const Token& keyword) {
    reading.options.integrator = read_statement(tokens, keyword);
}

void accelerator(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const Statement statement = read_statement(tokens, keyword);  // Embree builds its own tree
    statement.ignore({"maxnodeprims", "splitmethod", "intersectcost", "traversalcost", "emptybonus",
                      "maxprims", "maxdepth"});
    reading.log.warn_unused(statement);
}

void color_space(Reading& reading, TokenStream& tokens, const Token& keyword) {
    static constexpr std::array<std::string_view, 4> kSpaces = {"srgb", "aces2065-1", "rec2020",
                                                                "dci-p3"};
    const std::string name = tokens.require_string("the name of a colour space");
    const auto space = colour_space(name);
    if (!space)
        throw Error(keyword.where(), "unknown colour space " + in_quotes(name),
                    use_one_of(kSpaces, name));
    reading.state.colour_space = *space;
}

struct KnownOption {
    std::string_view name;
    std::string_view instead;  // what happens instead; empty: no effect on the picture
};

constexpr std::array<KnownOption, 11> kOptions = {
    {{"disablepixeljitter", "pixels are always sampled all over"},
     {"disabletexturefiltering", ""},
     {"disablewavelengthjitter", "wavelengths always vary between passes"},
     {"displacementedgescale", ""},
     {"forcediffuse", "materials are unchanged"},
     {"msereferenceimage", ""},
     {"msereferenceout", ""},
     {"pixelstats", ""},
     {"rendercoordsys", ""},
     {"seed", "use --seed"},
     {"wavefront", ""}}};

/// Removes case and underscores, which pbrt-v4 ignores.
std::string plain(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (c != '_' && c != '-')
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Reads Option "name" value: a number, a quoted string, true or false.
void option(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of an option");
    const Token value = tokens.require("the value of option " + in_quotes(name));
    const bool flag = value.text == "true" || value.text == "false";
    if (value.kind == TokenKind::word && !flag) real_of(value);
    if (value.kind == TokenKind::open || value.kind == TokenKind::close)
        throw Error(value.where(), "a list for option " + in_quotes(name), "give one value");
    const auto* const known = std::find_if(
        kOptions.begin(), kOptions.end(),
        [&](const KnownOption& o) { return o.name == plain(name.substr(name.rfind(' ') + 1)); });
    if (known == kOptions.end())
        reading.log.warn(keyword.where(), "unknown Option " + in_quotes(name) + " is ignored");
    else if (!known->instead.empty() && value.text != "false")
        reading.log.warn(keyword.where(), "Option " + in_quotes(name) +
                                              " is ignored: " + std::string(known->instead));
}

constexpr std::array<Directive, 8> kDirectives = {
    {{"Camera", Place::before_world, camera},
     {"Film", Place::before_world, film},
     {"PixelFilter", Place::before_world, filter},
     {"Sampler", Place::before_world, sampler},
     {"Integrator", Place::before_world, integrator},
     {"Accelerator", Place::before_world, accelerator},
     {"ColorSpace", Place::anywhere, color_space},
     {"Option", Place::anywhere, option}}};

}  // namespace

std::span<const Directive> option_directives() {
    return kDirectives;
}

}  // namespace sunfleck::engine
