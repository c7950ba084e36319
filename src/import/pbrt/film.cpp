// The picture as the scene asks for it, and hints for the renderer.
#include "import/pbrt/film.h"

#include "core/float_range.h"
#include "import/pbrt/data_vocabulary.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"
#include "scene/adjust.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

Vec2i resolution_of(const Statement& film) {
    const Vec2i size(film.integer("xresolution").value_or(1280),
                     film.integer("yresolution").value_or(720));
    check_film_size(size, film.where);
    return size;
}

std::optional<std::array<int, 4>> crop_of(const Statement& film, const Vec2i& size) {
    const auto window = film.reals("cropwindow", 4);
    const Parameter* bounds = film.find("pixelbounds", ParameterType::integer);
    if (!window && !bounds) return std::nullopt;
    std::array<int, 4> crop{};
    if (window) {
        const std::vector<double>& w = *window;
        crop = pixels_of_window({w[0], w[1], w[2], w[3]}, size);
    } else {
        if (bounds->integers.size() != 4)
            throw Error(bounds->where, "\"pixelbounds\" with other than 4 values",
                        "give x0 x1 y0 y1");
        const auto& b = bounds->integers;
        crop = {std::clamp(b[0], 0, size.x), std::clamp(b[1], 0, size.x),
                std::clamp(b[2], 0, size.y), std::clamp(b[3], 0, size.y)};
    }
    if (crop[0] < crop[1] && crop[2] < crop[3]) return crop;
    throw Error(film.where, "the crop leaves no pixel", "check \"cropwindow\" and \"pixelbounds\"");
}

void warn_approximations(const Statement& film, ImportLog& log) {
    if (film.type != "rgb")
        log.warn(film.where, "film " + in_quotes(film.type) + " is read as \"rgb\"");
    if (film.find("scale"))
        log.warn(film.where, "\"scale\" of Film is ignored, as in pbrt-v4: use \"iso\"");
    if (film.find("maxcomponentvalue"))
        log.warn(film.where, "\"maxcomponentvalue\" is ignored: nothing is clamped");
    film.ignore({"diagonal", "savefp16", "nbuckets", "lambdamin", "lambdamax", "coordinatesystem"});
}

/// Returns the temperature of the white point. Camera sensors without a given one use 6500 K, as in
/// pbrt-v4; their colours are those of the standard observer.
std::optional<double> white_of(const Statement& film, ImportLog& log) {
    static constexpr std::array<std::string_view, 18> kSensors = {
        "cie1931",           "canon_eos_100d",      "canon_eos_1dx_mkii",
        "canon_eos_200d",    "canon_eos_200d_mkii", "canon_eos_5d",
        "canon_eos_5d_mkii", "canon_eos_5d_mkiii",  "canon_eos_5d_mkiv",
        "canon_eos_5ds",     "canon_eos_m",         "hasselblad_l1d_20c",
        "nikon_d810",        "nikon_d850",          "sony_ilce_6400",
        "sony_ilce_7m3",     "sony_ilce_7rm3",      "sony_ilce_9"};
    const std::string sensor = film.text("sensor").value_or("cie1931");
    if (std::find(kSensors.begin(), kSensors.end(), sensor) == kSensors.end())
        throw Error(film.find("sensor")->where, "unknown sensor " + in_quotes(sensor),
                    use_one_of(kSensors, sensor));
    const bool is_camera = sensor != "cie1931";
    const double white = film.real("whitebalance", 0);
    if (is_camera)
        log.warn(film.where,
                 "sensor " + in_quotes(sensor) + " is read as \"cie1931\" with its white balance");
    if (white > 0) return std::max(white, 1000.0);
    if (is_camera) return 6500;
    return std::nullopt;
}

double iso_of(const Statement& film) {
    const double iso = film.real("iso", 100);
    if (iso > 0) return iso;
    throw Error(film.where, "\"iso\" is not positive", "use 100");
}

float imaging_ratio_of(const Statement& film, Reading& reading) {
    const auto& camera = reading.options.camera;
    const double seconds = camera ? exposure_time_of(*camera, reading.log) : 1;
    const double ratio = seconds * iso_of(film) / 100;
    const auto rounded = is_finite_float(ratio) ? static_cast<float>(ratio) : 0.0F;
    if (rounded > 0) return rounded;
    throw Error(film.where,
                "\"iso\" / 100 times the exposure time (\"shutterclose\" - \"shutteropen\" of the "
                "camera) is no positive finite float",
                "keep the product above 1e-38 and below 3.4e38");
}

void read_integrator(const Statement& integrator, Reading& reading) {
    RenderHints& hints = reading.scene.hints;
    reading.log.count_word(integrator.keyword, integrator.type);
    hints.integrator = integrator.type;
    hints.max_depth = integrator.integer("maxdepth");
    if (hints.max_depth && *hints.max_depth < 0)
        throw Error(integrator.where, "\"maxdepth\" is negative", "use 0 or more");
    if (integrator.type != "sppm") {
        reading.log.warn(integrator.where,
                         "integrator " + in_quotes(integrator.type) +
                             " is ignored except \"maxdepth\": photon mapping renders the scene, "
                             "unless --integrator is given");
        integrator.ignore_all();
        return;
    }
    if (const Parameter* radius = integrator.find("radius"))
        reading.log.warn(radius->where,
                         "\"radius\" of Integrator is ignored: the initial gather radius is 1 to 2 "
                         "pixels; set it with --radius");
    if (const Parameter* paths = integrator.find("photonsperiteration"))
        reading.log.warn(
            paths->where,
            "\"photonsperiteration\" is ignored: the number of photon paths per pass is "
            "automatic; set it with --photons-per-pass");
    integrator.ignore({"seed", "regularize"});
    reading.log.warn_unused(integrator);
}

/// The points and the count of a sampler have no effect.
void read_sampler(const Statement& sampler, Reading& reading) {
    reading.log.count_word(sampler.keyword, sampler.type);
    sampler.ignore({"pixelsamples", "xsamples", "ysamples", "jitter", "randomization", "seed"});
    reading.log.warn_unused(sampler);
}

struct FilterRow {
    std::string_view word;
    FilterKind kind;
    double radius;
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kFilters = std::to_array<FilterRow>({
    {"box", FilterKind::box, 0.5, kExact, "radius 0.5"},
    {"triangle", FilterKind::triangle, 2, kExact, "radius 2"},
    {"gaussian", FilterKind::gaussian, 1.5, kExact, "radius 1.5, `sigma` 0.5; the default"},
    {"mitchell", FilterKind::mitchell, 2, kExact, "radius 2, `B` and `C` 1/3"},
    {"sinc", FilterKind::sinc, 4, kExact, "radius 4, `tau` 3"},
});

}  // namespace

double exposure_time_of(const Statement& camera, ImportLog& log) {
    const double open = camera.real("shutteropen", 0);
    const double close = camera.real("shutterclose", 1);
    if (close < open)
        log.warn(camera.where, "the shutter closes before it opens: the times are swapped");
    if (close != open) return std::abs(close - open);
    throw Error(camera.where, "the shutter closes when it opens",
                "make \"shutterclose\" later than \"shutteropen\"");
}

FilmDescription film_of(const Statement& film, ImportLog& log) {
    FilmDescription result;
    static constexpr auto kTypes = words_of(kFilmWords);
    if (std::find(kTypes.begin(), kTypes.end(), film.type) == kTypes.end())
        throw Error(film.where, "unknown film " + in_quotes(film.type),
                    use_one_of(kTypes, film.type));
    result.resolution = resolution_of(film);
    result.crop = crop_of(film, result.resolution);
    result.filename = film.text("filename").value_or("");
    iso_of(film);
    result.white = white_of(film, log);
    warn_approximations(film, log);
    return result;
}

void finish_film(Reading& reading) {
    const Statement none{"Film", "rgb", {reading.scene.path}, {}, nullptr};
    const Statement& film = reading.options.film ? *reading.options.film : none;
    reading.scene.film = film_of(film, reading.log);
    if (reading.options.film) reading.log.count_word(film.keyword, film.type);
    reading.scene.film.imaging_ratio = imaging_ratio_of(film, reading);
    reading.log.warn_unused(film);
}

std::span<const WordRow> filter_words() {
    static constexpr auto kWords = word_rows("PixelFilter", kFilters);
    return kWords;
}

FilterSettings filter_of(const Statement& filter) {
    const auto* const row = std::find_if(kFilters.begin(), kFilters.end(),
                                         [&](const FilterRow& r) { return r.word == filter.type; });
    if (row == kFilters.end()) {
        throw Error(filter.where, "unknown filter " + in_quotes(filter.type),
                    use_one_of(words_of(kFilters), filter.type));
    }
    FilterSettings settings;
    settings.kind = row->kind;
    settings.radius = {filter.real("xradius", row->radius), filter.real("yradius", row->radius)};
    if (row->kind == FilterKind::gaussian) settings.sigma = filter.real("sigma", 0.5);
    if (row->kind == FilterKind::mitchell) {
        settings.b = filter.real("B", 1.0 / 3);
        settings.c = filter.real("C", 1.0 / 3);
    }
    if (row->kind == FilterKind::sinc) settings.tau = filter.real("tau", 3);
    const double least =
        std::min({settings.radius.x, settings.radius.y, settings.sigma, settings.tau});
    const double most = std::max(settings.radius.x, settings.radius.y);
    if (!(least > 0 && most <= 1000))
        throw Error(filter.where, "a filter whose radius, sigma or tau is out of range",
                    "use positive ones, radii of at most 1000 pixels");
    return settings;
}

void finish_filter(Reading& reading) {
    if (!reading.options.filter) return;
    const Statement& filter = *reading.options.filter;
    reading.scene.filter = filter_of(filter);
    reading.log.count_word(filter.keyword, filter.type);
    reading.log.warn_unused(filter);
}

void finish_hints(Reading& reading) {
    if (reading.options.integrator) read_integrator(*reading.options.integrator, reading);
    if (reading.options.sampler) read_sampler(*reading.options.sampler, reading);
}

}  // namespace sunfleck::engine
