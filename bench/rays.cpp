// bench_rays: rays a second of the photon pass and of the eye pass over those of Embree alone.
//
// usage: bench_rays [--triangles N] [--paths N] [--repeats N] [--resolution N] [--profile N]
// Only ratios within one run mean something: all is measured in turn, several times, and medians
// are printed. docs/performance.md says how to read the figures.
#include "core/parallel.h"
#include "estimate/deposit.h"
#include "photon/uniform_paths.h"
#include "raw_embree.h"
#include "render/pass.h"
#include "room.h"
#include "timing.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>

namespace sunfleck::bench {
namespace {

struct Settings {
    RoomSettings room;
    std::uint32_t paths = 100'000;
    int repeats = 5;
    std::uint32_t profile = 0;  // photon passes and nothing else, for a profiler
};

/// Rays a second: by the clock, and by processor time of one thread.
struct Rate {
    std::vector<double> wall;
    std::vector<double> cpu;

    void add(double rays, const Elapsed& elapsed) {
        wall.push_back(rays / elapsed.wall);
        cpu.push_back(rays / elapsed.cpu);
    }
};

struct Rates {
    Rate photon;
    Rate raw_photon;
    Rate trace;  // photon paths where nothing gathers: the tracer alone
    Rate eye;
    Rate raw_eye;
};

struct Recorded {
    std::vector<RecordedRay> photon;
    std::vector<RecordedRay> eye;
};

struct Bench {
    const Scene& scene;
    const RawEmbree& raw;
    const Recorded& rays;
    std::uint32_t paths;

    void run(Rates& rates) const;
};

/// A pass as far as its photons: what they are traced through and deposited in.
struct Prepared {
    PassId id{0, 0};
    PassScene scene;
    TransportSettings transport;
    PassImage image;
    std::vector<VisiblePoint> points;
    Statistics eye;
    Elapsed eye_time;

    explicit Prepared(const Scene& of) : scene(of, id), image(window_of(of.film()).pixels(), {}) {
        const EyeSettings settings;
        const EyePass pass{scene, transport, settings, window_of(of.film()), id, 1};
        eye_time = time_of([&] { points = trace_eye_paths(pass, image, eye); });
    }
};

void Bench::run(Rates& rates) const {
    Prepared pass(scene);
    rates.eye.add(static_cast<double>(pass.eye[Count::eye_rays]), pass.eye_time);
    rates.raw_eye.add(static_cast<double>(rays.eye.size()), time_of([&] { raw.trace(rays.eye); }));

    const VisiblePointIndex index(std::move(pass.points), pass.transport.max_depth);
    const PhotonTracer tracer(pass.scene, pass.transport);
    const Depositor deposit(pass.scene, index, pass.image, paths);
    const UniformPaths uniform{UniformKind::uniform, pass.id, paths};
    const auto may_take = [&](const Photon& photon) { return index.may_take(photon); };
    Statistics photon;
    const Elapsed photon_time =
        time_of([&] { photon = trace_uniform_paths(tracer, uniform, may_take, deposit); });
    const auto count = static_cast<double>(photon[Count::photon_rays]);
    rates.photon.add(count, photon_time);
    rates.raw_photon.add(static_cast<double>(rays.photon.size()),
                         time_of([&] { raw.trace(rays.photon); }));
    const auto nowhere = [](const Photon&) { return false; };
    rates.trace.add(count, time_of([&] { trace_batches(tracer, uniform, {0, paths}, nowhere); }));
}

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
    const Scene scene(bumpy_room(settings.room));
    const ThreadLimit limit(1);
    Prepared pass(scene);
    const VisiblePointIndex index(std::move(pass.points), pass.transport.max_depth);
    const PhotonTracer tracer(pass.scene, pass.transport);
    const Depositor deposit(pass.scene, index, pass.image, settings.paths);
    const auto may_take = [&](const Photon& photon) { return index.may_take(photon); };
    const Elapsed elapsed = time_of([&] {
        for (std::uint32_t i = 0; i < settings.profile; ++i)
            trace_uniform_paths(tracer, {UniformKind::uniform, {0, i}, settings.paths}, may_take,
                                deposit);
    });
    fmt::print("{} photon passes: {:.3f} s, {:.3f} s of the processor\n", settings.profile,
               elapsed.wall, elapsed.cpu);
}

void run(const Settings& settings, std::size_t threads) {
    const Scene scene(bumpy_room(settings.room));
    const RawEmbree raw(scene);
    const PassId id{0, 0};
    const Recorded rays{photon_rays(scene, settings.paths, id), eye_rays(scene, id)};
    fmt::print("{} triangles, {} photon paths, {} photon rays and {} eye rays recorded\n",
               scene.geometry().triangle_count(), settings.paths, rays.photon.size(),
               rays.eye.size());
    const Bench bench{scene, raw, rays, settings.paths};
    std::map<std::size_t, Rates> rates;
    for (int repeat = 0; repeat < settings.repeats; ++repeat)
        for (const std::size_t count : {std::size_t{1}, threads}) {
            const ThreadLimit limit(count);
            bench.run(rates[count]);
        }
    for (const auto& [count, r] : rates) {
        print_rate("photon pass", count, r.photon, r.raw_photon);
        print_rate("photon paths alone", count, r.trace, r.raw_photon);
        print_rate("eye pass", count, r.eye, r.raw_eye);
        print_rate("Embree, photon rays", count, r.raw_photon, r.raw_photon);
        print_rate("Embree, eye rays", count, r.raw_eye, r.raw_eye);
    }
    const Rates& one = rates[1];
    const Rates& many = rates[threads];
    print_scaling("photon pass", one.photon, many.photon, one.raw_photon, many.raw_photon);
    print_scaling("eye pass", one.eye, many.eye, one.raw_eye, many.raw_eye);
}

}  // namespace
}  // namespace sunfleck::bench

int main(int count, char** words) {
    sunfleck::bench::Settings settings;
    std::size_t threads = 2;
    int resolution = 512;
    CLI::App app("Rays a second of the photon and the eye pass over those of Embree alone");
    app.add_option("--triangles", settings.room.triangles, "About so many (default 131072)");
    app.add_option("--paths", settings.paths, "Photon paths (default 100000)");
    app.add_option("--repeats", settings.repeats, "Measurements of each (default 5)");
    app.add_option("--resolution", resolution, "Pixels a side (default 512)");
    app.add_option("--threads", threads, "Compared with one thread (default 2)");
    app.add_option("--profile", settings.profile,
                   "Only run the photons of so many passes on one thread, for a profiler");
    CLI11_PARSE(app, count, words);
    settings.room.resolution = {resolution, resolution};
    if (settings.profile > 0)
        sunfleck::bench::profile(settings);
    else
        sunfleck::bench::run(settings, threads);
    return 0;
}
