// bench_gain: what a photon sampler or another integrator is worth: error times processor time of
// one over another's.
//
// usage: bench_gain SCENE [--samplers random,adaptive] [--passes N] [--seeds N] [--references N]
// Renders of the samplers are interleaved, seed by seed; the last sampler, with other seeds, is the
// reference, of the same passes and so of the same radii: what is compared is noise alone. Errors
// are corrected for the reference's own.
#include "core/parallel.h"
#include "core/random.h"
#include "film/film.h"
#include "film/luminance.h"
#include "import/load.h"
#include "render/progressive.h"
#include "scene/adjust.h"
#include "timing.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <map>

namespace sunfleck::bench {
namespace {

struct Settings {
    std::string scene;
    std::vector<std::string> samplers = {"random", "adaptive"};
    std::uint32_t passes = 16;
    std::uint32_t seeds = 8;
    std::uint32_t references = 16;
    int resolution = 256;
    std::size_t threads = 2;
    bool photons_only = false;
};

struct Rendered {
    std::vector<double> luminance;
    double seconds = 0;  // of the processor
    double visible_fraction = 0;
    double starved = 0;
};

Rendered rendered(const Scene& scene, const Settings& settings, const std::string& sampler,
                  std::uint64_t seed) {
    RenderJob job{scene, {}, {}, 0};
    job.settings.seed = seed;
    if (scene.hints().max_depth) job.settings.transport.max_depth = *scene.hints().max_depth;
    if (const auto integrator = integrator_named(sampler))
        job.settings.integrator = *integrator;
    else
        job.settings.photon.sampler = sampler_named(sampler).value();
    if (sampler == "paper") use_paper_mode(job.settings);
    if (settings.photons_only) job.settings.transport.direct = DirectLight::photons;
    job.stop.end_pass = settings.passes;
    Rendered result;
    std::optional<RenderResult> render_result;
    result.seconds = time_of([&] { render_result.emplace(render(job, {})); }).cpu;
    const Film& film = render_result->film;
    const auto passes = static_cast<double>(film.pass_count());
    const FixedPoints& sums = film.sums().layers[0];
    for (std::size_t i = 0; i < sums.size(); i += 3)
        result.luminance.push_back(
            RgbSum{{sums[i], sums[i + 1], sums[i + 2]}}.mean_luminance(passes));
    result.visible_fraction = film.statistic("visible_fraction") / passes;
    result.starved = film.statistic("starved_passes");
    return result;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// Mean over pixels of squared error / (reference^2 + 0.01 mean^2), and the same without the
/// pixel's own brightness.
struct Error {
    double relative = 0;
    double plain = 0;
};

Error error_of(const std::vector<double>& image, const std::vector<double>& reference) {
    const double mean = mean_of(reference);
    Error error;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double square = (image[i] - reference[i]) * (image[i] - reference[i]);
        error.relative += square / (reference[i] * reference[i] + 0.01 * mean * mean);
        error.plain += square / (mean * mean);
    }
    error.relative /= static_cast<double>(image.size());
    error.plain /= static_cast<double>(image.size());
    return error;
}

struct Sample {
    Error error;
    double seconds;
    double brightness;
    std::vector<double> image;  // of the sampler `paper` alone
};

/// Errors around the mean of the samples, corrected for what the mean shares with each.
void measure_by_own_mean(std::vector<Sample>& samples) {
    const auto count = static_cast<double>(samples.size());
    std::vector<double> mean(samples.front().image.size());
    for (const Sample& s : samples)
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += s.image[i] / count;
    for (Sample& s : samples) {
        s.error = error_of(s.image, mean);
        s.error.relative *= count / (count - 1);
        s.error.plain *= count / (count - 1);
    }
}

using Samples = std::map<std::string, std::vector<Sample>>;

double mean_by(const std::vector<Sample>& samples, const std::vector<std::size_t>& which,
               double Error::*measure) {
    double error = 0;
    double seconds = 0;
    for (const std::size_t i : which) {
        error += samples[i].error.*measure;
        seconds += samples[i].seconds;
    }
    return error / static_cast<double>(which.size()) * seconds;
}

/// The ratio of error times seconds, and its 95% interval by drawing seeds again with repetition.
void print_ratio(const std::string& name, const std::vector<Sample>& a,
                 const std::vector<Sample>& b, double Error::*measure) {
    constexpr int kDraws = 2000;
    std::vector<std::size_t> all(a.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const double ratio = mean_by(a, all, measure) / mean_by(b, all, measure);
    RandomStream random(1, Purpose::test, 0, 0);
    std::vector<double> ratios;
    for (int draw = 0; draw < kDraws; ++draw) {
        std::vector<std::size_t> first;
        std::vector<std::size_t> second;
        const auto size = static_cast<double>(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            first.push_back(static_cast<std::size_t>(random.next() * size));
            second.push_back(static_cast<std::size_t>(random.next() * size));
        }
        ratios.push_back(mean_by(a, first, measure) / mean_by(b, second, measure));
    }
    std::sort(ratios.begin(), ratios.end());
    fmt::print("{:<34} {:10.4g}   [{:.4g}, {:.4g}]\n", name, ratio, ratios[kDraws / 40],
               ratios[kDraws - kDraws / 40]);
}

/// Takes the reference's own error out: it is the mean of so many renders of the last sampler.
void correct(Samples& samples, const std::string& last, std::uint32_t references) {
    Error own;
    for (const Sample& s : samples[last]) {
        own.relative += s.error.relative;
        own.plain += s.error.plain;
    }
    const double share = static_cast<double>(samples[last].size()) * (references + 1.0);
    for (auto& [name, list] : samples)
        for (Sample& s : list) {
            if (name == "paper") continue;
            s.error.relative -= own.relative / share;
            s.error.plain -= own.plain / share;
        }
}

void run(const Settings& settings) {
    SceneDescription description = load_scene(settings.scene);
    set_resolution(description, {settings.resolution, settings.resolution});
    const Scene scene(std::move(description));
    const ThreadLimit limit(settings.threads);
    const std::string& last = settings.samplers.back();
    std::vector<double> reference;
    for (std::uint32_t i = 0; i < settings.references; ++i) {
        const Rendered r = rendered(scene, settings, last, 1'000'000 + i);
        reference.resize(r.luminance.size());
        for (std::size_t k = 0; k < reference.size(); ++k)
            reference[k] += r.luminance[k] / settings.references;
    }
    Samples samples;
    std::map<std::string, Rendered> facts;
    for (std::uint32_t seed = 0; seed < settings.seeds; ++seed)
        for (const std::string& sampler : settings.samplers) {
            Rendered r = rendered(scene, settings, sampler, seed);
            samples[sampler].push_back(
                {error_of(r.luminance, reference), r.seconds, mean_of(r.luminance), {}});
            if (sampler == "paper") samples[sampler].back().image = std::move(r.luminance);
            facts[sampler].visible_fraction += r.visible_fraction / settings.seeds;
            facts[sampler].starved += r.starved;
        }
    if (samples.contains("paper")) measure_by_own_mean(samples["paper"]);
    correct(samples, last, settings.references);
    fmt::print("{}: {} seeds of {} passes, reference brightness {:.5g}\n", settings.scene,
               settings.seeds, settings.passes, mean_of(reference));
    for (const std::string& sampler : settings.samplers) {
        std::vector<double> brightness;
        Error error;
        double seconds = 0;
        for (const Sample& s : samples[sampler]) {
            brightness.push_back(s.brightness);
            error.relative += s.error.relative / settings.seeds;
            error.plain += s.error.plain / settings.seeds;
            seconds += s.seconds / settings.seeds;
        }
        const double mean = mean_of(brightness);
        double square = 0;
        for (const double b : brightness) square += (b - mean) * (b - mean);
        fmt::print(
            "{:<9} brightness {:.5g} +- {:.2g}  spread {:.2f}%  relMSE {:.4g}  MSE {:.4g}  "
            "{:.2f} s  visible {:.3g}  starved {}\n",
            sampler, mean, std::sqrt(square / settings.seeds / (settings.seeds - 1)),
            100 * std::sqrt(square / (settings.seeds - 1)) / mean, error.relative, error.plain,
            seconds, facts[sampler].visible_fraction, facts[sampler].starved);
    }
    for (const std::string& sampler : settings.samplers) {
        if (sampler == last) continue;
        print_ratio(sampler + " over " + last + ", relMSE x cpu s", samples[sampler], samples[last],
                    &Error::relative);
        print_ratio(sampler + " over " + last + ", MSE x cpu s", samples[sampler], samples[last],
                    &Error::plain);
    }
}

}  // namespace
}  // namespace sunfleck::bench

int main(int count, char** words) {
    sunfleck::bench::Settings settings;
    CLI::App app("Error times processor time of photon samplers, over that of the last one");
    app.add_option("SCENE", settings.scene, "Scene file")->required();
    const auto is_sampler = [](const std::string& name) {
        return sunfleck::sampler_named(name) || sunfleck::integrator_named(name)
                   ? std::string()
                   : "there is no sampler or integrator " + name;
    };
    app.add_option("--samplers", settings.samplers, "Or integrators (default random,adaptive)")
        ->delimiter(',')
        ->check(is_sampler);
    app.add_option("--passes", settings.passes, "Of each render (default 16)");
    app.add_option("--seeds", settings.seeds, "Renders of each sampler (default 8)");
    app.add_option("--references", settings.references, "Renders of the reference (default 16)");
    app.add_option("--resolution", settings.resolution, "Pixels a side (default 256)");
    app.add_option("--threads", settings.threads, "Default 2");
    app.add_flag("--photons-only", settings.photons_only, "Direct light by photons, too");
    CLI11_PARSE(app, count, words);
    sunfleck::bench::run(settings);
    return 0;
}
