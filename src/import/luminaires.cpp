// Lights by number or name, and the frames of their luminaires.
#include "import/luminaires.h"

#include "core/input_file.h"
#include "import/ies/light.h"
#include "math/warp.h"
#include "sky/compass.h"

#include <charconv>

namespace sunfleck::engine {
namespace {

/// Returns the statement that `light` means: its number from 1, or the name in its quotes.
std::uint32_t statement_of(const SceneDescription& scene, const std::string& light) {
    const auto count = static_cast<std::uint32_t>(scene.light_statements.size());
    std::uint32_t number = 0;
    const char* const end = light.data() + light.size();
    const auto [rest, fault] = std::from_chars(light.data(), end, number);
    if (fault == std::errc() && rest == end && number >= 1 && number <= count) return number - 1;
    for (std::uint32_t i = 0; i < count; ++i)
        if (scene.light_statements[i].what.ends_with('"' + light + '"')) return i;
    throw Error({"--ies"}, "the scene has no light \"" + light + '"',
                "give its number or name as sunfleck info --lights has it");
}

/// Returns a rotation that takes -z to `nadir`. @param nadir  unit.
Affine hung_along(const Vec3d& nadir) {
    Affine frame;
    frame.x = rotate_z_to(-nadir, {1, 0, 0});
    frame.y = rotate_z_to(-nadir, {0, 1, 0});
    frame.z = -nadir;
    return frame;
}

/// Returns the light with the intensities of `map`, or nothing if it is no point and no spot.
std::optional<GoniometricLight> hung(const Light& light, const Affine& upright,
                                     const std::shared_ptr<const LightImage>& map) {
    if (const auto* point = std::get_if<PointLight>(&light))
        return GoniometricLight{per_candela(point->curve), point->position, map, upright};
    if (const auto* spot = std::get_if<SpotLight>(&light))
        return GoniometricLight{per_candela(spot->curve), spot->position, map,
                                hung_along(spot->axis)};
    return {};
}

}  // namespace

void set_luminaires(SceneDescription& scene, const std::vector<AskedLuminaire>& asked, UpAxis up) {
    const Affine upright = compass(up, 0);
    for (const AskedLuminaire& luminaire : asked) {
        const std::uint32_t statement = statement_of(scene, luminaire.light);
        const Photometry photometry(read_input_file(luminaire.file, {"--ies"}), luminaire.file);
        const auto map = intensity_map(photometry);
        bool is_hung = false;
        for (std::size_t i = 0; i < scene.lights.size() && i < scene.stated_in.size(); ++i) {
            if (scene.stated_in[i] != statement) continue;
            auto now = hung(scene.lights[i], upright, map);
            if (!now) continue;
            scene.lights[i] = std::move(*now);
            is_hung = true;
        }
        if (!is_hung)
            throw Error({"--ies"},
                        "light \"" + luminaire.light + "\" is " +
                            scene.light_statements[statement].what + ", no point and no spot",
                        "choose another light");
        scene.files.push_back(luminaire.file);
    }
}

}  // namespace sunfleck::engine
