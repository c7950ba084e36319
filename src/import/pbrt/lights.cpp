// Lights with pbrt-v4's scale: rgb is unchanged, other spectra are divided by their luminance,
// "power" and "illuminance" (if positive) multiply "scale".
#include "import/pbrt/lights.h"

#include "core/float_range.h"
#include "import/pbrt/light_directions.h"
#include "import/pbrt/light_images.h"
#include "import/pbrt/light_scale.h"
#include "import/pbrt/luminaire_lights.h"
#include "import/pbrt/portals.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/sky_lights.h"
#include "import/pbrt/words.h"
#include "math/trigonometry.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

Vec3d position_of(const Statement& statement, const Matrix& to_world) {
    const Vec3d position = statement.point("from", {0, 0, 0}) * to_world;
    if (is_finite_float(position.x) && is_finite_float(position.y) && is_finite_float(position.z))
        return position;
    throw Error(statement.where, "the place of the light is beyond the range of floats",
                "keep its coordinates in the world below 3.4e38");
}

Light point_light(const Statement& statement, Reading& reading) {
    return PointLight{
        scaled_emission(statement, emission_of(statement, "I", reading), {"power", 4 * kPiDouble}),
        position_of(statement, reading.still_matrix(statement.where))};
}

/// Covers all directions, with z and y exchanged as in pbrt-v4.
Light goniometric_light(const Statement& statement, Reading& reading) {
    if (!statement.find("filename")) {
        reading.log.warn(statement.where,
                         "a goniometric light without \"filename\" is read as a point light");
        return point_light(statement, reading);
    }
    if (names_luminaire(statement)) return luminaire_light(statement, reading);
    const auto distribution = intensity_image(statement, reading);
    Affine to_world = turn_of(statement, reading);
    std::swap(to_world.y, to_world.z);
    const double at_one = 4 * kPiDouble * distribution->mean();
    return GoniometricLight{scaled_emission(statement, emission_of(statement, "I", reading),
                                            {"power", at_one}, distribution->peak()),
                            Affine(reading.still_matrix(statement.where)).origin, distribution,
                            to_world};
}

/// "fov" is that of the shorter side; rows of the image go against y.
Light projection_light(const Statement& statement, Reading& reading) {
    Image image = light_image(statement, reading);
    const double fov = statement.real("fov", 90);
    if (!(fov > 0 && fov < 180))
        throw Error(statement.where, "\"fov\" of the projection is not in (0, 180)",
                    "use 45, for example");
    const SinCos corner = sin_cos_2pi(fov / 720);
    const Vec2d size(image.resolution());
    const Vec2d half = size * (corner.sin / corner.cos / std::min(size.x, size.y));
    const auto distribution = projected_image(std::move(image), half);
    Affine to_world = turn_of(statement, reading);
    to_world.y = -to_world.y;
    const double at_one = 4 * half.x * half.y * distribution->mean();
    return ProjectionLight{
        scaled_emission(statement, Spectrum::d65(), {"power", at_one}, distribution->peak()),
        Affine(reading.still_matrix(statement.where)).origin, half, distribution, to_world};
}

Light spot_light(const Statement& statement, Reading& reading) {
    const Matrix& to_world = reading.still_matrix(statement.where);
    const double cone = statement.real("coneangle", 30);
    const double delta = statement.real("conedeltaangle", 5);
    if (!(cone > 0 && cone <= 180 && delta >= 0))
        throw Error(statement.where, "the angles of the spot do not form a cone",
                    "use \"coneangle\" in (0, 180] and \"conedeltaangle\" of 0 or more");
    const double cos_total = sin_cos_2pi(cone / 360).cos;
    const double cos_start = sin_cos_2pi(std::max(cone - delta, 0.0) / 360).cos;
    const double solid_angle = 2 * kPiDouble * ((1 - cos_start) + (cos_start - cos_total) / 2);
    return SpotLight{
        scaled_emission(statement, emission_of(statement, "I", reading), {"power", solid_angle}),
        position_of(statement, to_world), direction_of(statement, to_world), cos_total, cos_start};
}

Light distant_light(const Statement& statement, Reading& reading) {
    return DistantLight{
        scaled_emission(statement, emission_of(statement, "L", reading), {"illuminance", 1}),
        direction_of(statement, reading.still_matrix(statement.where))};
}

Light image_infinite_light(const Statement& statement, Reading& reading) {
    EnvironmentImage read = environment_image(statement, reading);
    const auto distribution = image_of_directions(std::move(read.image), read.map);
    // pbrt-v4 sums 2 pi / texels per texel, half of the solid angle.
    const double at_one = illuminance_from_above(*distribution, read.map) / 2;
    return ImageInfiniteLight{
        scaled_emission(statement, Spectrum::d65(), {"illuminance", at_one}, distribution->peak()),
        distribution, turn_of(statement, reading), read.map};
}

Light infinite_light(const Statement& statement, Reading& reading) {
    const Parameter* both = statement.find("L");
    if (both && statement.find("filename"))
        throw Error(both->where, "an infinite light with \"L\" and \"filename\"",
                    "give one of them");
    if (statement.find("portal")) return portal_light(statement, reading);
    if (statement.find("filename")) return image_infinite_light(statement, reading);
    return InfiniteLight{scaled_emission(statement, emission_of(statement, "L", reading),
                                         {"illuminance", kPiDouble})};
}

using Maker = std::vector<Light> (*)(const Statement&, Reading&);

template <Light (*make)(const Statement&, Reading&)>
std::vector<Light> one(const Statement& statement, Reading& reading) {
    return {make(statement, reading)};
}

struct Row {
    std::string_view word;
    Maker maker;
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kRows = std::to_array<Row>({
    {"point", one<point_light>, kExact, "`I`, `from`, `scale`, `power`"},
    {"spot", one<spot_light>, kExact,
     "`I`, `from`, `to`, `coneangle`, `conedeltaangle`, `scale`, `power`"},
    {"distant", one<distant_light>, kExact, "`L`, `from`, `to`, `scale`, `illuminance`"},
    {"infinite", one<infinite_light>, kExact,
     "`L` or `filename`, `portal`, `scale`, `illuminance`"},
    {"goniometric", one<goniometric_light>, kExact, "`I`, `filename`, `scale`, `power`"},
    {"projection", one<projection_light>, kExact, "`filename`, `fov`, `scale`, `power`"},
    {"sun", one<sun_light>, kOurs, "`L`, `angle`, `from`, `to`, `scale`, `illuminance`"},
    {"sky", sky_lights, kOurs, "`azimuth`, `elevation`, `turbidity`, `groundalbedo`, `scale`"},
});

}  // namespace

std::uint32_t note_light(const Statement& statement, Reading& reading) {
    std::vector<LightStatement>& all = reading.scene.light_statements;
    all.push_back({statement.title(), statement.where});
    return static_cast<std::uint32_t>(all.size() - 1);
}

std::span<const WordRow> light_words() {
    static constexpr auto kWords = word_rows("LightSource", kRows);
    return kWords;
}

void add_light(const Statement& statement, Reading& reading) {
    const auto* const row = std::find_if(kRows.begin(), kRows.end(),
                                         [&](const Row& r) { return r.word == statement.type; });
    if (row == kRows.end()) {
        throw Error(statement.where, "unknown light " + in_quotes(statement.type),
                    statement.type == "diffuse"
                        ? "make it the area light of a shape (AreaLightSource)"
                        : use_one_of(words_of(kRows), statement.type));
    }
    reading.log.count_word(statement.keyword, statement.type);
    std::vector<Light> made = row->maker(statement, reading);  // before anything is noted
    const std::uint32_t stated_in = note_light(statement, reading);
    const MediumNumber around =
        reading.media.number_of(reading.state.outside_medium, statement.where);
    for (Light& light : made) {
        reading.scene.lights.push_back(std::move(light));
        reading.scene.stated_in.push_back(stated_in);
        reading.scene.media.at_lights.push_back({around, around});
    }
    reading.log.warn_unused(statement);
}

AreaEmission area_emission(const Statement& statement, Reading& reading) {
    if (statement.type != "diffuse")
        throw Error(statement.where, "unknown area light " + in_quotes(statement.type),
                    "use \"diffuse\"");
    reading.log.count_word(statement.keyword, statement.type);
    AreaEmission emission;
    if (statement.find("filename")) {
        if (const Parameter* both = statement.find("L"))
            throw Error(both->where, "an area light with \"L\" and \"filename\"",
                        "give one of them");
        emission.image = std::make_shared<const SurfaceImage>(light_image(statement, reading));
    }
    emission.radiance = scaled_emission(statement, emission_of(statement, "L", reading), {},
                                        emission.image ? emission.image->peak() : 1);
    emission.two_sided = statement.flag("twosided", false);
    emission.power = std::max(statement.real("power", 0), 0.0);
    reading.log.warn_unused(statement);
    return emission;
}

}  // namespace sunfleck::engine
