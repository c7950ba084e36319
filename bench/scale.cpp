// bench_scale: what a pass costs against triangles, photons, pixels and threads, and what it
// keeps in memory.
//
// usage: bench_scale [--large] [--repeats N]
// Each row is one variable changed, all else as in the row of the same table that is marked; times
// are medians. docs/lab/performance.md says how to read the figures.
#include "camera_paths/trace_camera_paths.h"
#include "core/parallel.h"
#include "program.h"
#include "render/pass.h"
#include "room.h"
#include "timing.h"
#include "visible_points/visible_point_index.h"

#include <fmt/format.h>

namespace sunfleck::engine::bench {
namespace {

struct Case {
    std::string name;
    RoomSettings room;
    std::uint32_t paths = 200'000;
    std::size_t threads = 1;
};

struct Cost {
    double build = 0;   // seconds: geometry and tree
    double camera = 0;  // of a pass
    double index = 0;
    double photon = 0;
    double rays = 0;  // of the photon pass
};

Cost cost_of(const Case& c, int repeats) {
    const ThreadLimit limit(c.threads);
    SceneDescription description = bumpy_room(c.room);
    std::optional<Scene> scene;
    Cost cost;
    cost.build = time_of([&] { scene.emplace(std::move(description)); }).wall;
    RenderSettings settings;
    settings.photon.paths_per_pass = c.paths;
    std::vector<double> camera;
    std::vector<double> index;
    std::vector<double> photon;
    for (int i = 0; i < repeats; ++i) {
        const PassResult pass = render_pass(*scene, settings, static_cast<std::uint32_t>(i));
        camera.push_back(pass.seconds.camera);
        index.push_back(pass.seconds.index);
        photon.push_back(pass.seconds.photon);
        cost.rays = static_cast<double>(pass.statistics[Count::photon_rays]);
    }
    cost.camera = median(camera);
    cost.index = median(index);
    cost.photon = median(photon);
    return cost;
}

void print_table(const char* title, const std::vector<Case>& cases, int repeats) {
    fmt::print("\n{}\n{:<12} {:>9} {:>9} {:>9} {:>9} {:>14} {:>8}\n", title, "", "build s",
               "camera s", "index s", "photon s", "photon rays/s", "over 1st");
    double first = 0;
    for (const Case& c : cases) {
        const Cost cost = cost_of(c, repeats);
        const double rate = cost.rays / cost.photon;
        if (first == 0) first = rate;
        fmt::print("{:<12} {:>9.3f} {:>9.4f} {:>9.4f} {:>9.4f} {:>14.0f} {:>8.2f}\n", c.name,
                   cost.build, cost.camera, cost.index, cost.photon, rate, rate / first);
    }
}

/// Bytes a pixel that a pass holds on to.
void print_memory() {
    fmt::print("\nbytes a pixel\n{:<12} {:>15} {:>8} {:>11}\n", "", "visible points", "index",
               "pass image");
    for (const int size : {128, 512, 1024}) {
        const Scene scene(bumpy_room({10'000, {size, size}}));
        const PassId id{0, 0};
        const PassScene at_wavelengths(scene, id);
        const TransportSettings transport;
        const CameraPathSettings settings;
        const PixelWindow window = window_of(scene.film());
        PassImage image(window.pixels(), {});
        Statistics statistics;
        const CameraPass pass{at_wavelengths, transport, settings, window, id, 1};
        auto points = trace_camera_paths(pass, image, statistics);
        const auto pixels = static_cast<double>(window.pixels());
        const double held =
            static_cast<double>(statistics[Count::visible_points] * sizeof(VisiblePoint));
        const VisiblePointIndex index(std::move(points), transport.max_depth);
        fmt::print("{:<12} {:>15.1f} {:>8.1f} {:>11}\n", fmt::format("{0} x {0}", size),
                   held / pixels, static_cast<double>(index.bytes()) / pixels - held / pixels,
                   sizeof(PassImage::Pixel));
    }
}

void run(bool large, int repeats) {
    std::vector<Case> triangles;
    for (const std::size_t n : {10'000, 100'000, 1'000'000, 10'000'000}) {
        if (n > 1'000'000 && !large) continue;
        triangles.push_back({fmt::format("{:.0e}", static_cast<double>(n)), {n, {256, 256}}});
    }
    print_table("triangles (256 x 256, 200,000 photon paths, 1 thread)", triangles, repeats);
    std::vector<Case> photons;
    for (const std::uint32_t n : {50'000U, 200'000U, 800'000U})
        photons.push_back({fmt::format("{}", n), {100'000, {256, 256}}, n});
    print_table("photon paths a pass (100,000 triangles, 256 x 256, 1 thread)", photons, repeats);
    std::vector<Case> sizes;
    for (const int n : {64, 128, 256, 512, 1024})
        sizes.push_back({fmt::format("{0} x {0}", n), {100'000, {n, n}}});
    print_table("pixels (100,000 triangles, 200,000 photon paths, 1 thread)", sizes, repeats);
    std::vector<Case> threads;
    for (std::size_t n = 1; n <= thread_count(); n *= 2)
        threads.push_back({fmt::format("{}", n), {100'000, {256, 256}}, 200'000, n});
    print_table("threads (100,000 triangles, 256 x 256, 200,000 photon paths)", threads, repeats);
    print_memory();
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    bool large = false;
    int repeats = 3;
    CLI::App app("What a pass costs against triangles, photons, pixels and threads");
    app.add_flag("--large", large, "Also ten million triangles (some 3 GB)");
    app.add_option("--repeats", repeats, "Passes of each (default 3)");
    return sunfleck::engine::bench::run_program(
        app, count, words, [&] { sunfleck::engine::bench::run(large, repeats); });
}
