// bench_rays: rays a second of the photon pass and of the camera pass over those of Embree alone.
//
// usage: bench_rays [SCENE] [--sampler NAME] [--paths N] [--repeats N] [--resolution N]
//                   [--profile N]
// Without a scene: a bumpy room of --triangles N. Only ratios within one run mean something: all is
// measured in turn, several times, and medians are printed. docs/lab/performance.md says how to
// read the figures.
#include "camera_paths/trace_camera_paths.h"
#include "core/parallel.h"
#include "import/load.h"
#include "photon_samplers/samplers.h"
#include "program.h"
#include "raw_embree.h"
#include "render/pass.h"
#include "room.h"
#include "scene/adjust.h"
#include "timing.h"

#include <fmt/format.h>

#include <map>

namespace sunfleck::engine::bench {
namespace {

struct Settings {
    std::string scene;  // a file; or none
    std::size_t triangles = 131'072;
    int resolution = 512;
    std::uint32_t paths = 100'000;
    PhotonSampler sampler = PhotonSampler::uniform;
    int repeats = 5;
    std::uint32_t profile = 0;  // photon passes and nothing else, for a profiler
};

/// Rays a second: by the clock, and by processor time of one thread.
struct Rate {
    std::vector<double> wall;
    std::vector<double> cpu;

    void add(std::size_t rays, const Elapsed& elapsed) {
        wall.push_back(static_cast<double>(rays) / elapsed.wall);
        cpu.push_back(static_cast<double>(rays) / elapsed.cpu);
    }
};

struct Rates {
    Rate photon;
    Rate raw_photon;
    Rate trace;  // photon paths where nothing gathers: the tracer alone; of `uniform`
    Rate camera;
    Rate raw_camera;
};

/// Pass 0 of a scene in its stages.
class Pass {
public:
    explicit Pass(const Settings& settings)
        : settings_(settings),
          scene_(scene_of(settings)),
          strata_(strata_of(scene_, settings)),
          at_wavelengths_(scene_, kId) {
        PassImage to = image();
        points_ = camera_paths(to);
    }

    std::size_t triangles() const { return scene_.geometry().triangle_count(); }

    PassImage image() const { return {window_of(scene_.film()).pixels(), {}}; }

    VisiblePointLists camera_paths(PassImage& image) const {
        Statistics counts;
        return trace_camera_paths(camera_pass(), image, counts);
    }

    VisiblePointIndex index() const { return {points_, transport_.max_depth}; }
    VisiblePointIndex index_of_nothing() const {
        return {VisiblePointLists(), transport_.max_depth};
    }

    /// The photons of a pass like this one. @param number  names its random numbers.
    void photons(const VisiblePointIndex& index, PassImage& image, std::uint32_t number = 0) const {
        const PhotonContext context{at_wavelengths_, transport_, index};
        PhotonSettings photon;
        photon.sampler = settings_.sampler;
        SamplerState state;  // of the samplers here, none has any
        trace_photons({context, {0, number}, strata_, photon}, {image}, state);
    }

private:
    static constexpr PassId kId{0, 0};

    CameraPass camera_pass() const {
        return {at_wavelengths_, transport_, camera_settings_, window_of(scene_.film()), kId, 1};
    }

    static Scene scene_of(const Settings& settings) {
        const Vec2i resolution(settings.resolution, settings.resolution);
        if (settings.scene.empty()) return Scene(bumpy_room({settings.triangles, resolution}));
        SceneDescription description = load_scene(settings.scene);
        set_resolution(description, resolution);
        for (const ShapeDescription& shape : description.shapes)
            if (!std::holds_alternative<TriangleMesh>(shape.placed.shape) || shape.placed.cover)
                throw Error({settings.scene}, "it has other shapes than triangles, or cut-outs",
                            "rays to these cannot be traced by Embree alone: take another scene");
        return Scene(std::move(description));
    }

    static std::vector<LightStratum> strata_of(const Scene& scene, const Settings& settings) {
        RenderSettings render;
        render.photon.sampler = settings.sampler;
        render.photon.paths_per_pass = settings.paths;
        return learn_epoch(scene, render, 0).strata;
    }

    const Settings& settings_;
    Scene scene_;
    std::vector<LightStratum> strata_;
    PassScene at_wavelengths_;
    TransportSettings transport_;
    CameraPathSettings camera_settings_;
    VisiblePointLists points_;
};

struct Bench {
    const Pass& pass;
    const RawEmbree& photon_rays;
    const RawEmbree& camera_rays;
    bool paths_alone;

    void run(Rates& rates) const {
        PassImage image = pass.image();
        rates.camera.add(camera_rays.size(), time_of([&] { pass.camera_paths(image); }));
        rates.raw_camera.add(camera_rays.size(), time_of([&] { camera_rays.trace(); }));
        const VisiblePointIndex index = pass.index();
        rates.photon.add(photon_rays.size(), time_of([&] { pass.photons(index, image); }));
        rates.raw_photon.add(photon_rays.size(), time_of([&] { photon_rays.trace(); }));
        if (!paths_alone) return;
        const VisiblePointIndex nothing = pass.index_of_nothing();
        rates.trace.add(photon_rays.size(), time_of([&] { pass.photons(nothing, image); }));
    }
};

double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
    return median(ratios);
}

void print_rate(const char* name, std::size_t threads, const Rate& rate, const Rate& raw) {
    fmt::print(
        "{:<22} {} threads  {:7.3f} M/s  {:7.3f} M/s a thread by cpu   over Embree {:.3f} "
        "wall, {:.3f} cpu\n",
        name, threads, median(rate.wall) * 1e-6, median(rate.cpu) * 1e-6,
        median_ratio(rate.wall, raw.wall), median_ratio(rate.cpu, raw.cpu));
}

void print_scaling(const char* name, const Rate& one, const Rate& many, const Rate& raw_one,
                   const Rate& raw_many) {
    const double own = median_ratio(many.wall, one.wall);
    const double raw = median_ratio(raw_many.wall, raw_one.wall);
    const double own_cpu = median_ratio(many.cpu, one.cpu);
    const double raw_cpu = median_ratio(raw_many.cpu, raw_one.cpu);
    fmt::print(
        "scaling {:<14} {:.3f}, Embree's own {:.3f}: ratio {:.3f}   (cost a ray by cpu: "
        "{:.3f}, {:.3f}: {:.3f})\n",
        name, own, raw, own / raw, own_cpu, raw_cpu, own_cpu / raw_cpu);
}

/// Photons of many passes over the visible points of one.
void profile(const Settings& settings) {
    const ThreadLimit limit(1);
    const Pass pass(settings);
    const VisiblePointIndex index = pass.index();
    PassImage image = pass.image();
    const Elapsed elapsed = time_of([&] {
        for (std::uint32_t i = 0; i < settings.profile; ++i) pass.photons(index, image, i);
    });
    fmt::print("{} photon passes: {:.3f} s, {:.3f} s of the processor\n", settings.profile,
               elapsed.wall, elapsed.cpu);
}

void run(const Settings& settings, std::size_t threads) {
    const Pass pass(settings);
    PassImage image = pass.image();
    const RawEmbree camera_rays = RawEmbree::record([&] { pass.camera_paths(image); });
    const VisiblePointIndex index = pass.index();
    const RawEmbree photon_rays = RawEmbree::record([&] { pass.photons(index, image); });
    fmt::print("{} triangles, {} photon paths, {} photon rays and {} camera rays recorded\n",
               pass.triangles(), settings.paths, photon_rays.size(), camera_rays.size());
    const bool paths_alone = settings.sampler == PhotonSampler::uniform;
    const Bench bench{pass, photon_rays, camera_rays, paths_alone};
    std::map<std::size_t, Rates> rates;
    for (int repeat = 0; repeat < settings.repeats; ++repeat)
        for (const std::size_t count : {std::size_t{1}, threads}) {
            const ThreadLimit limit(count);
            bench.run(rates[count]);
        }
    for (const auto& [count, r] : rates) {
        print_rate("photon pass", count, r.photon, r.raw_photon);
        if (paths_alone) print_rate("photon paths alone", count, r.trace, r.raw_photon);
        print_rate("camera pass", count, r.camera, r.raw_camera);
        print_rate("Embree, photon rays", count, r.raw_photon, r.raw_photon);
        print_rate("Embree, camera rays", count, r.raw_camera, r.raw_camera);
    }
    const Rates& one = rates[1];
    const Rates& many = rates[threads];
    print_scaling("photon pass", one.photon, many.photon, one.raw_photon, many.raw_photon);
    print_scaling("camera pass", one.camera, many.camera, one.raw_camera, many.raw_camera);
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    sunfleck::engine::bench::Settings settings;
    std::size_t threads = 2;
    CLI::App app("Rays a second of the photon and the camera pass over those of Embree alone");
    app.add_option("scene", settings.scene, "Of triangles alone (default a bumpy room)");
    app.add_option("--triangles", settings.triangles, "Of that room, about (default 131072)");
    std::map<std::string, sunfleck::engine::PhotonSampler> samplers;
    for (const sunfleck::engine::PhotonSamplerRow& row : sunfleck::engine::kPhotonSamplers)
        if (row.sampler != sunfleck::engine::PhotonSampler::paper)
            samplers.emplace(row.name, row.sampler);
    app.add_option("--sampler", settings.sampler, "Of photons (default uniform)")
        ->transform(CLI::CheckedTransformer(samplers));
    app.add_option("--paths", settings.paths, "Photon paths (default 100000)");
    app.add_option("--repeats", settings.repeats, "Measurements of each (default 5)");
    app.add_option("--resolution", settings.resolution, "Pixels a side (default 512)");
    app.add_option("--threads", threads, "Compared with one thread (default 2)");
    app.add_option("--profile", settings.profile,
                   "Only run the photons of so many passes on one thread, for a profiler");
    return sunfleck::engine::bench::run_program(app, count, words, [&] {
        if (settings.profile > 0)
            sunfleck::engine::bench::profile(settings);
        else
            sunfleck::engine::bench::run(settings, threads);
    });
}
