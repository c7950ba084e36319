// bench_load: loading a mesh from a binary PLY file, against reading its bytes and building
// Embree's tree of it; and what each keeps in memory.
//
// usage: bench_load [--triangles N]... [--repeats N]
// Each part runs in a process of its own, in turn, the file in the page cache: "bytes" reads the
// file; "embree" builds a tree over arrays that are there; "sunfleck" loads the scene, ready to be
// rendered. Memory is the most that a process had resident, less what an idle one has; that of
// Embree holds the mesh (points and indices), too. docs/lab/performance.md has figures.
#include "import/load.h"

#include "geometry/embree.h"
#include "procedural/mesh.h"
#include "program.h"
#include "scene/scene.h"
#include "timing.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace sunfleck::engine::bench {
namespace {

/// A field of low hills, in a square of side one.
Mesh hills(std::size_t triangles) {
    const auto cells = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2));
    Mesh mesh;
    mesh.points.reserve((cells + 1) * (cells + 1) + 1);  // Embree reads 16 bytes a point
    mesh.triangles.reserve(2 * cells * cells);
    for (std::uint32_t i = 0; i <= cells; ++i)
        for (std::uint32_t j = 0; j <= cells; ++j) {
            const float x = static_cast<float>(i) / static_cast<float>(cells);
            const float y = static_cast<float>(j) / static_cast<float>(cells);
            mesh.points.push_back({x, y, 0.02F * std::sin(40 * x) * std::cos(70 * y)});
        }
    const std::uint32_t row = cells + 1;
    for (std::uint32_t i = 0; i < cells; ++i)
        for (std::uint32_t j = 0; j < cells; ++j)
            mesh.add_quad(i * row + j, (i + 1) * row + j, (i + 1) * row + j + 1, i * row + j + 1);
    return mesh;
}

constexpr const char* kScene = R"(Camera "perspective"
WorldBegin
LightSource "distant"
Shape "plymesh" "string filename" "mesh.ply"
)";

struct Cost {
    double seconds = 0;
    double megabytes = 0;
};

/// Runs work() in a process of its own. @param work  returns the seconds that count.
Cost cost_of(const std::function<double()>& work) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        const double seconds = work();
        const bool written = write(pipe_ends[1], &seconds, sizeof seconds) == sizeof seconds;
        _exit(written ? 0 : 1);
    }
    close(pipe_ends[1]);
    Cost cost;
    const bool read_back =
        read(pipe_ends[0], &cost.seconds, sizeof cost.seconds) == sizeof cost.seconds;
    close(pipe_ends[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    if (!read_back || status != 0) throw std::runtime_error("a part failed");
    cost.megabytes = static_cast<double>(used.ru_maxrss) / 1024;
    return cost;
}

std::string read_bytes(const std::string& path) {
    std::string bytes(std::filesystem::file_size(path), '\0');
    std::ifstream(path, std::ios::binary)
        .read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

double measure_bytes(const std::string& folder) {
    return time_of([&] { read_bytes(folder + "/mesh.ply"); }).wall;
}

/// The same kind of tree as ours, over indexed triangles.
double measure_embree(std::size_t triangles) {
    const Mesh mesh = hills(triangles);
    const embree::Device device = embree::open_device("avx2");
    return time_of([&] {
               const embree::Scene scene = embree::new_scene(device.get());
               const embree::Geometry geometry =
                   embree::new_geometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
               rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                          RTC_FORMAT_FLOAT3, mesh.points.data(), 0,
                                          sizeof(mesh.points[0]), mesh.points.size());
               rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                                          RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                                          sizeof(mesh.triangles[0]), mesh.triangles.size());
               rtcCommitGeometry(geometry.get());
               rtcAttachGeometry(scene.get(), geometry.get());
               embree::commit(scene.get());
               embree::check(device.get());
           })
        .wall;
}

double measure_sunfleck(const std::string& folder) {
    return time_of([&] { Scene scene(load_scene(folder + "/scene.pbrt")); }).wall;
}

Cost median_of(const std::vector<Cost>& costs) {
    std::vector<double> seconds;
    std::vector<double> megabytes;
    for (const Cost& c : costs) {
        seconds.push_back(c.seconds);
        megabytes.push_back(c.megabytes);
    }
    return {median(seconds), median(megabytes)};
}

void measure(std::size_t triangles, int repeats, const std::string& folder) {
    const std::string path = folder + "/mesh.ply";
    cost_of([&] {  // in a process of its own, so that the others do not inherit its memory
        std::ofstream(path, std::ios::binary) << ply_bytes(hills(triangles));
        return 0.0;
    });
    std::vector<Cost> bytes;
    std::vector<Cost> embree;
    std::vector<Cost> ours;
    const double idle = cost_of([] { return 0.0; }).megabytes;
    for (int i = 0; i < repeats; ++i) {
        bytes.push_back(cost_of([&] { return measure_bytes(folder); }));
        embree.push_back(cost_of([&] { return measure_embree(triangles); }));
        ours.push_back(cost_of([&] { return measure_sunfleck(folder); }));
    }
    const Cost b = median_of(bytes);
    const Cost e = median_of(embree);
    const Cost s = median_of(ours);
    fmt::print("{:>11} {:>8.2f} {:>8.2f} {:>8.2f} {:>6.2f} {:>9.0f} {:>9.0f} {:>6.2f}\n", triangles,
               b.seconds, e.seconds, s.seconds, s.seconds / (b.seconds + e.seconds),
               e.megabytes - idle, s.megabytes - idle, (s.megabytes - idle) / (e.megabytes - idle));
}

void run(const std::vector<std::size_t>& triangles, int repeats) {
    const auto folder = std::filesystem::temp_directory_path() /
                        fmt::format("sunfleck-bench-load-{}", static_cast<long>(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.pbrt") << kScene;
    fmt::print("{:>11} {:>8} {:>8} {:>8} {:>6} {:>9} {:>9} {:>6}\n", "triangles", "bytes s",
               "embree s", "ours s", "ratio", "embree MB", "ours MB", "ratio");
    for (const std::size_t count : triangles) measure(count, repeats, folder.string());
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    CLI::App app("loading of meshes, against Embree's own build");
    std::vector<std::size_t> triangles = {100'000, 1'000'000, 10'000'000};
    int repeats = 3;
    app.add_option("--triangles", triangles);
    app.add_option("--repeats", repeats);
    return sunfleck::engine::bench::run_program(
        app, count, words, [&] { sunfleck::engine::bench::run(triangles, repeats); });
}
