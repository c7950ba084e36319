// bench_gain: what a photon sampler or another integrator is worth: error times processor time of
// one over another's.
//
// usage: bench_gain SCENE [--samplers random,adaptive] [--passes N] [--seeds N] [--references N]
//                   [--over SCENE] [--region X0,X1,Y0,Y1] [--reference-radius SHARE]
//                   [--indirect-radius FACTOR]
// A number is `adaptive` with so many photon paths a pass; without-PART is it without that part (a
// name of kAdaptiveParts in photon/settings.h, or ris), "bare" without all of them,
// "gathered" with all light by photons, that from lamps to glossy surfaces, too. --over compares
// the last sampler with itself in another scene. Renders of the samplers are interleaved, seed by
// seed; the last sampler, with other seeds, is the reference, of the same passes and so of the same
// radii: what is compared is noise alone (that of `paper`, whose radii differ, around its own
// mean). --reference-radius .25 gives the reference discs of a quarter of the radius: then bias
// counts, for all. Errors are corrected for the reference's own.
#include "core/named_rows.h"
#include "core/parallel.h"
#include "film/film.h"
#include "film/luminance.h"
#include "gain_errors.h"
#include "import/load.h"
#include "photon_samplers/samplers.h"
#include "program.h"
#include "render/progressive.h"
#include "scene/adjust.h"
#include "timing.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace sunfleck::engine::bench {
namespace {

/// The sampler `adaptive` without a part, or all of them, or with all light by photons.
/// @return whether there is a variant of that name.
bool apply_variant(std::string_view name, RenderSettings& settings) {
    constexpr std::string_view kWithout = "without-";
    bool known = name == "bare" || name == "gathered";
    if (name == "gathered") settings.transport.direct = DirectLight::photons;
    const auto is_off = [&](std::string_view part) {
        const bool named = name.starts_with(kWithout) && name.substr(kWithout.size()) == part;
        known = known || named;
        return named || name == "bare";
    };
    if (is_off("ris")) settings.camera.ris = false;
    for (const AdaptivePart& part : kAdaptiveParts)
        if (is_off(part.name)) settings.photon.*part.is_on = false;
    return known;
}

/// The sampler `adaptive` with so many photon paths a pass.
bool is_number(const std::string& name) {
    return !name.empty() && name.size() < 10 &&
           name.find_first_not_of("0123456789") == std::string::npos;
}

struct Settings {
    std::string scene;
    std::string other_scene;
    std::vector<std::string> samplers = {"random", "adaptive"};
    std::uint32_t passes = 16;
    std::uint32_t seeds = 8;
    std::uint32_t references = 16;
    double reference_radius = 1;            // over that of what is measured
    std::optional<double> indirect_radius;  // CameraPathSettings::indirect_radius
    int resolution = 256;
    std::size_t threads = 2;
    bool photons_only = false;
    std::vector<double> region = {0, 1, 0, 1};  // left, right, top, bottom: shares of the picture
};

struct Rendered {
    std::vector<double> luminance;
    double seconds = 0;  // of the processor
    double visible_fraction = 0;
    double starved = 0;
};

Rendered rendered(const Scene& scene, const Settings& settings, const std::string& sampler,
                  std::uint64_t seed, double radius = 1) {
    RenderJob job{scene, {}, {}, 0};
    job.settings.seed = seed;
    if (scene.hints().max_depth) job.settings.transport.max_depth = *scene.hints().max_depth;
    if (const auto* row = row_named(kIntegrators, sampler))
        job.settings.integrator = row->value;
    else if (is_number(sampler))
        job.settings.photon.paths_per_pass = static_cast<std::uint32_t>(std::stoul(sampler));
    else if (!apply_variant(sampler, job.settings))
        job.settings.photon.sampler = row_named(kPhotonSamplers, sampler)->sampler;
    if (sampler == "paper") use_paper_mode(job.settings);
    CameraPathSettings& camera = job.settings.camera;
    if (settings.indirect_radius) camera.indirect_radius = settings.indirect_radius;
    if (radius != 1) {
        const Vec2i resolution = scene.film().resolution;
        camera.indirect_radius = indirect_radius_scale(camera, resolution);
        camera.radius_pixels = first_radius(camera, resolution) * radius;
    }
    if (settings.photons_only) job.settings.transport.direct = DirectLight::photons;
    job.stop.end_pass = settings.passes;
    Rendered result;
    std::optional<RenderResult> render_result;
    result.seconds = time_of([&] { render_result.emplace(render(job, {})); }).cpu;
    const Film& film = render_result->film;
    const auto passes = static_cast<double>(film.pass_count());
    const FixedPoints& sums = film.sums().aovs[0];
    const std::vector<double>& region = settings.region;
    const auto at = [&](double share) { return std::lround(share * settings.resolution); };
    for (long y = at(region[2]); y < at(region[3]); ++y)
        for (long x = at(region[0]); x < at(region[1]); ++x) {
            const auto i = static_cast<std::size_t>(3 * (y * settings.resolution + x));
            result.luminance.push_back(
                RgbSum{{sums[i], sums[i + 1], sums[i + 2]}}.mean_luminance(passes));
        }
    result.visible_fraction = film.statistic("visible_fraction") / passes;
    result.starved = film.statistic("starved_passes");
    return result;
}

/// One scene and the samplers that render it.
class Contest {
public:
    Contest(const Settings& settings, const std::string& scene,
            const std::vector<std::string>& samplers)
        : settings_(settings),
          name_(scene),
          samplers_(samplers),
          scene_(loaded(scene, settings.resolution)) {
        std::vector<Sample> renders;
        for (std::uint32_t i = 0; i < settings.references; ++i)
            renders.push_back(sample_of(
                rendered(scene_, settings, last(), 1'000'000 + i, settings.reference_radius)));
        reference_ = mean_image(renders);
        reference_error_ = error_of_mean(renders, reference_);
    }

    const std::string& last() const { return samplers_.back(); }
    const std::vector<Sample>& of_last() { return samples_[last()]; }

    void render_seed(std::uint32_t seed) {
        for (const std::string& sampler : samplers_) {
            Rendered r = rendered(scene_, settings_, sampler, seed);
            facts_[sampler].visible_fraction += r.visible_fraction / settings_.seeds;
            facts_[sampler].starved += r.starved;
            samples_[sampler].push_back(sample_of(std::move(r)));
        }
    }

    void finish() {
        for (auto& [sampler, list] : samples_) {
            if (sampler == "paper" && settings_.reference_radius == 1)
                measure_by_own_mean(list, reference_);
            else
                measure_by(list, reference_, reference_error_);
        }
        fmt::print("{}: {} seeds of {} passes, reference brightness {:.5g}\n", name_,
                   settings_.seeds, settings_.passes, mean_of(reference_));
        for (const std::string& sampler : samplers_) print(sampler);
        for (const std::string& sampler : samplers_) {
            if (sampler == last()) continue;
            print_ratios(sampler + " over " + last(), samples_[sampler], samples_[last()]);
        }
    }

private:
    static Scene loaded(const std::string& name, int resolution) {
        SceneDescription description = load_scene(name);
        set_resolution(description, {resolution, resolution});
        return Scene(std::move(description));
    }

    static Sample sample_of(Rendered r) {
        const double brightness = mean_of(r.luminance);
        return {{}, r.seconds, brightness, std::move(r.luminance)};
    }

    void print(const std::string& sampler) {
        std::vector<double> brightness;
        Error error;
        double seconds = 0;
        for (const Sample& s : samples_[sampler]) {
            brightness.push_back(s.brightness);
            error.relative += s.error.relative / settings_.seeds;
            error.plain += s.error.plain / settings_.seeds;
            seconds += s.seconds / settings_.seeds;
        }
        const double mean = mean_of(brightness);
        double square = 0;
        for (const double b : brightness) square += (b - mean) * (b - mean);
        fmt::print(
            "{:<24} brightness {:.5g} +- {:.2g}  spread {:.2f}%  relMSE {:.4g}  MSE {:.4g}  "
            "{:.2f} s  visible {:.3g}  starved {}\n",
            sampler, mean, std::sqrt(square / settings_.seeds / (settings_.seeds - 1)),
            100 * std::sqrt(square / (settings_.seeds - 1)) / mean, error.relative, error.plain,
            seconds, facts_[sampler].visible_fraction, facts_[sampler].starved);
    }

    const Settings& settings_;
    std::string name_;
    std::vector<std::string> samplers_;
    Scene scene_;
    std::vector<double> reference_;
    Error reference_error_;
    Samples samples_;
    std::map<std::string, Rendered> facts_;
};

void run(const Settings& settings) {
    const ThreadLimit limit(settings.threads);
    Contest contest(settings, settings.scene, settings.samplers);
    std::optional<Contest> other;
    if (!settings.other_scene.empty())
        other.emplace(settings, settings.other_scene, std::vector<std::string>{contest.last()});
    for (std::uint32_t seed = 0; seed < settings.seeds; ++seed) {
        contest.render_seed(seed);
        if (other) other->render_seed(seed);
    }
    contest.finish();
    if (!other) return;
    other->finish();
    print_ratios(contest.last() + " here over there", contest.of_last(), other->of_last());
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    sunfleck::engine::bench::Settings settings;
    CLI::App app("Error times processor time of photon samplers, over that of the last one");
    app.add_option("SCENE", settings.scene, "Scene file")->required();
    const auto is_sampler = [](const std::string& name) {
        sunfleck::engine::RenderSettings unused;
        const bool known =
            sunfleck::engine::row_named(sunfleck::engine::kPhotonSamplers, name) != nullptr ||
            sunfleck::engine::row_named(sunfleck::engine::kIntegrators, name) != nullptr ||
            sunfleck::engine::bench::apply_variant(name, unused) ||
            sunfleck::engine::bench::is_number(name);
        return known ? std::string() : "there is no sampler or integrator " + name;
    };
    app.add_option("--samplers", settings.samplers,
                   "Or integrators, a number, without-PART, bare, gathered (default "
                   "random,adaptive)")
        ->delimiter(',')
        ->check(is_sampler);
    app.add_option("--over", settings.other_scene, "Compare the last sampler with it there");
    app.add_option("--passes", settings.passes, "Of each render (default 16)");
    app.add_option("--seeds", settings.seeds, "Renders of each sampler (default 8)");
    app.add_option("--references", settings.references, "Renders of the reference (default 16)")
        ->check(CLI::Range(2, 10'000));
    app.add_option("--reference-radius", settings.reference_radius,
                   "Of the reference's discs, over those measured (default 1)")
        ->check(CLI::Range(0.01, 1.0));
    app.add_option("--indirect-radius", settings.indirect_radius,
                   "Of discs for indirect light, over those for other light")
        ->check(CLI::Range(1.0, 100.0));
    app.add_option("--resolution", settings.resolution, "Pixels a side (default 256)");
    app.add_option("--threads", settings.threads, "Default 2");
    app.add_flag("--photons-only", settings.photons_only, "Direct light by photons, too");
    app.add_option("--region", settings.region,
                   "Errors of a part of the picture: X0,X1,Y0,Y1 between 0 and 1")
        ->delimiter(',')
        ->expected(4)
        ->check(CLI::Range(0.0, 1.0));
    return sunfleck::engine::bench::run_program(app, count, words,
                                                [&] { sunfleck::engine::bench::run(settings); });
}
