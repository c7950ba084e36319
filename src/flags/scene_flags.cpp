// The rows of the flags of a scene.
#include "flags/scene_flags.h"

#include "flags/render_flags.h"
#include "flags/sun_value.h"
#include "flags/values.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

using Formats = std::vector<SceneFormat>;
const Formats kAny = {SceneFormat::pbrt, SceneFormat::gltf, SceneFormat::part};
const Formats kGltf = {SceneFormat::gltf};
const Formats kPart = {SceneFormat::part};

std::string name_text(const std::string& text, const std::string& flag) {
    if (text.empty()) throw Error({flag}, "the name is empty", "give one, or leave it out");
    return text;
}

/// Returns the value of one of the words. @param words  pairs of word and value.
template <class Value>
Value choice_of(const std::string& text, const std::string& flag,
                std::initializer_list<std::pair<const char*, Value>> words) {
    std::string all;
    for (const auto& [word, value] : words) {
        if (text == word) return value;
        all += (all.empty() ? "" : " or ") + std::string(word);
    }
    throw Error({flag}, "does not take \"" + text + "\"", "use " + all);
}

/// Reads "MEAN_FREE_PATH[,ALBEDO,G]".
Fog read_fog(const std::string& text, const std::string& flag) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    if (parts.size() != 1 && parts.size() != 3)
        throw Error({flag}, "\"" + text + "\" is no MEAN_FREE_PATH[,ALBEDO,G]",
                    "write for instance 20 or 20,0.9,0.7");
    Fog fog{.mean_free_path = read_number(parts[0], flag, 1e-6, 1e12)};
    if (parts.size() == 1) return fog;
    fog.albedo = read_number(parts[1], flag, 0, 1);
    fog.g = read_number(parts[2], flag, -0.99, 0.99);
    return fog;
}

std::vector<SceneFlag> light_rows() {
    return {
        {.name = "--sun",
         .form = "AZIMUTH,ELEVATION|DATE,TIME,LATITUDE,LONGITUDE",
         .help = "Add a clear sky with its sun: where it stands in degrees, clockwise from north "
                 "and above the horizon, or when and where: 2026-06-21,15:30+02:00,48.2,16.4 "
                 "(default for scenes other than pbrt's that have no light: 225,40)",
         .formats = kAny,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.daylight.sun = read_sun(text, flag);
                 r.has_daylight = true;
             }},
        {.name = "--turbidity",
         .form = "X",
         .help = "How hazy that sky is (1 to 10; default 3)",
         .formats = kAny,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.daylight.turbidity = read_number(text, flag, 1, 10);
             }},
        {.name = "--ground-albedo",
         .form = "X",
         .help = "What the ground around the scene reflects (0 to 1; default 0.3)",
         .formats = kAny,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.daylight.ground_albedo = read_number(text, flag, 0, 1);
             }},
        {.name = "--environment",
         .form = "FILE",
         .help = "Add an environment picture, .hdr or .exr: of latitude and longitude, twice as "
                 "wide as high, or square of equal areas",
         .formats = kAny,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 if (!r.environment) r.environment.emplace();
                 r.environment->file = name_text(text, flag);
             }},
        {.name = "--environment-scale",
         .form = "X",
         .help = "Brightness of that picture (default 1)",
         .formats = kAny,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 if (!r.environment) r.environment.emplace();
                 r.environment->scale = read_number(text, flag, 0, 1e9);
             }},
        {.name = "--ies",
         .form = "LIGHT=FILE",
         .help = "Give a point or spot, by its number or name in sunfleck info --lights, the "
                 "intensities of a luminaire's IES file; may be repeated",
         .formats = {SceneFormat::pbrt, SceneFormat::gltf},
         .repeats = true,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 const std::size_t equals = text.find('=');
                 if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
                     throw Error({flag}, "\"" + text + "\" is no LIGHT=FILE",
                                 "write for instance 1=lamp.ies");
                 r.luminaires.push_back({text.substr(0, equals), text.substr(equals + 1)});
             }},
        {.name = "--fog",
         .form = "MEAN_FREE_PATH[,ALBEDO,G]",
         .help =
             "Fill the air with fog: the mean way of light between two events in it, in units of "
             "the scene; the part of them that scatters (default 1), and the mean cosine of the "
             "angle by which they bend (default 0)",
         .formats = kAny,
         .read = [](SceneRequest& r, const std::string& text,
                    const std::string& flag) { r.fog = read_fog(text, flag); }},
        {.name = "--north",
         .form = "DEGREES",
         .help = "Where north is for sun and environment, clockwise from +y, or from -z where y is "
                 "up (-360 to 360; default 0)",
         .formats = kAny,
         .read = [](SceneRequest& r, const std::string& text,
                    const std::string& flag) { r.north = read_number(text, flag, -360, 360); }},
        {.name = "--up",
         .form = "y|z",
         .help = "The axis that points up, in scenes that do not say it (default z, but y for OBJ "
                 "and PLY)",
         .formats = {SceneFormat::pbrt, SceneFormat::part},
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.up = choice_of<UpAxis>(text, flag, {{"y", UpAxis::y}, {"z", UpAxis::z}});
             }},
    };
}

std::vector<SceneFlag> pbrt_rows() {
    return {
        {.name = "--subsurface",
         .form = "approximate|walk",
         .help = "Subsurface scattering as a coat over a diffuse surface of the same albedo, or as "
                 "a medium below a dielectric (default approximate)",
         .formats = {SceneFormat::pbrt},
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.subsurface =
                     choice_of<SubsurfaceRule>(text, flag,
                                               {{"approximate", SubsurfaceRule::approximated},
                                                {"walk", SubsurfaceRule::walked}});
             }},
    };
}

std::vector<SceneFlag> gltf_rows() {
    return {
        {.name = "--camera",
         .form = "NAME",
         .help = "The camera by its name, or its number from 1 (default the first)",
         .formats = kGltf,
         .read = [](SceneRequest& r, const std::string& text,
                    const std::string& flag) { r.import.camera = name_text(text, flag); }},
        {.name = "--variant",
         .form = "NAME",
         .help = "The variant of materials by its name",
         .formats = kGltf,
         .read = [](SceneRequest& r, const std::string& text,
                    const std::string& flag) { r.import.variant = name_text(text, flag); }},
        {.name = "--glass",
         .form = "auto|solid|thin",
         .help = "Whether glass fills its surfaces, or these are panes; auto: it fills closed ones",
         .formats = {SceneFormat::gltf, SceneFormat::part},
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.glass = choice_of<GlassRule>(text, flag,
                                                       {{"auto", GlassRule::automatic},
                                                        {"solid", GlassRule::solid},
                                                        {"thin", GlassRule::thin}});
             }},
        {.name = "--emission-unit",
         .form = "nit|watt",
         .help = "The unit of emission (default nit, but watt in Blender's files)",
         .formats = kGltf,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.emission_unit = choice_of<EmissionUnit>(
                     text, flag, {{"nit", EmissionUnit::nit}, {"watt", EmissionUnit::watt}});
             }},
        {.name = "--frame-time",
         .form = "SECONDS",
         .help = "The moment of animations (default 0)",
         .formats = kGltf,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.frame_time = read_number(text, flag, 0, 1e9);
             }},
    };
}

std::vector<SceneFlag> part_rows() {
    return {
        {.name = "--material",
         .form = "NAME",
         .help = "The material of parts that have none, such as glass:bk7, gold or plaster",
         .formats = kPart,
         .read = [](SceneRequest& r, const std::string& text,
                    const std::string& flag) { r.import.material = name_text(text, flag); }},
        {.name = "--unit",
         .form = "m|cm|mm|in",
         .help = "The unit of length (default m, but mm for STL)",
         .formats = kPart,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.metres_per_unit = choice_of<double>(
                     text, flag, {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}});
             }},
        {.name = "--ground",
         .form = "on|off",
         .help = "A ground under the part",
         .formats = kPart,
         .read =
             [](SceneRequest& r, const std::string& text, const std::string& flag) {
                 r.import.ground = choice_of<bool>(text, flag, {{"on", true}, {"off", false}});
             }},
    };
}

}  // namespace

const std::vector<SceneFlag>& scene_flags() {
    static const std::vector<SceneFlag> kAll = [] {
        std::vector<SceneFlag> all = light_rows();
        for (auto rows : {pbrt_rows(), gltf_rows(), part_rows()})
            all.insert(all.end(), rows.begin(), rows.end());
        return all;
    }();
    return kAll;
}

const SceneFlag& scene_flag(const std::string& name) {
    for (const SceneFlag& flag : scene_flags())
        if (flag.name == flag_name(name)) return flag;
    throw Error({flag_name(name)}, "is no flag of a scene", "see sunfleck render --help");
}

void set_scene_flag(SceneRequest& request, const SceneFlag& flag, const std::string& text) {
    for (const GivenFlag& given : request.given)
        if (!flag.repeats && given.name == flag.name)
            throw Error({flag.name}, "is given twice", "give it once");
    flag.read(request, text, flag.name);
    request.given.push_back({flag.name, text, flag.formats});
}

std::string text_of(const SceneRequest& request) {
    std::vector<std::string> lines;
    for (const GivenFlag& given : request.given)
        lines.push_back(given.name + ' ' + given.text + '\n');
    std::sort(lines.begin(), lines.end());
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

}  // namespace sunfleck::engine
