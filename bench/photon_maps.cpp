// bench_photon_maps: pictures of where photons go: seen from above, the photons that land on a
// square of the plane z = 0, by each sampler, and the sets of the splitting there.
//
// usage: bench_photon_maps SCENE -o DIR [--centre x y] [--width w]. Writes DIR/SCENE-photons.png:
// random, paper, adaptive; and DIR/SCENE-splitting.png: the states of each set but the last, and
// the sets themselves.
#include "camera_paths/trace_camera_paths.h"
#include "image/png.h"
#include "import/load.h"
#include "photon/paper_chain.h"
#include "photon/photon_space.h"
#include "planning/learn_epoch.h"
#include "program.h"
#include "random_numbers/emission_points.h"
#include "render/pass.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace sunfleck::engine::bench {
namespace {

struct Settings {
    std::string scene;
    std::string folder = ".";
    std::array<float, 2> centre = {4, -5};
    float width = 16;
    int pixels = 320;
    std::uint32_t paths = 200'000;
};

/// Where on the square photons landed, one number a cell.
class Map {
public:
    explicit Map(const Settings& s)
        : settings_(s), counts_(static_cast<std::size_t>(s.pixels * s.pixels), 0) {}

    void add(const Vec3& place, double weight) {
        if (std::abs(place.z) > 1e-3F) return;
        const auto cell = [&](float x, float centre) {
            return std::floor((x - centre + settings_.width / 2) / settings_.width *
                              static_cast<float>(settings_.pixels));
        };
        const float x = cell(place.x, settings_.centre[0]);
        const float y = cell(-place.y, -settings_.centre[1]);
        const auto size = static_cast<float>(settings_.pixels);
        if (!(x >= 0 && y >= 0 && x < size && y < size)) return;
        counts_[static_cast<std::size_t>(y * size + x)] += weight;
    }

    Vec3 place(std::size_t cell) const {
        const auto size = static_cast<std::size_t>(settings_.pixels);
        const auto at = [&](std::size_t i) {
            return (static_cast<float>(i) + 0.5F) / static_cast<float>(size) - 0.5F;
        };
        return {settings_.centre[0] + at(cell % size) * settings_.width,
                settings_.centre[1] - at(cell / size) * settings_.width, 0};
    }

    std::size_t cells() const { return counts_.size(); }
    void set(std::size_t cell, double value) { counts_[cell] = value; }

    /// Light: 1 where none landed, the darker the more.
    float paper(std::size_t cell) const {
        constexpr double kBlack = 16;
        const double ink = std::min(1.0, std::log1p(counts_[cell]) / std::log1p(kBlack));
        return static_cast<float>((1 - ink) * (1 - ink) * (1 - ink));
    }

private:
    const Settings& settings_;
    std::vector<double> counts_;
};

/// Maps side by side, with grey bars between them.
void write_row(const Settings& settings, const std::string& name, const std::vector<Map>& maps) {
    constexpr std::size_t kBar = 4;
    const auto size = static_cast<std::size_t>(settings.pixels);
    Picture picture;
    picture.width = static_cast<int>(maps.size() * (size + kBar) - kBar);
    picture.height = settings.pixels;
    for (const char* channel : {"R", "G", "B"}) {
        std::vector<float>& values = picture.add(channel).values;
        std::fill(values.begin(), values.end(), 0.3F);
        for (std::size_t m = 0; m < maps.size(); ++m)
            for (std::size_t i = 0; i < maps[m].cells(); ++i)
                values[i / size * static_cast<std::size_t>(picture.width) + m * (size + kBar) +
                       i % size] = maps[m].paper(i);
    }
    const auto stem = std::filesystem::path(settings.scene).stem().string();
    write_png(settings.folder + "/" + stem + "-" + name + ".png", picture);
}

/// Every photon of a path, with the height that it gives the path.
class WholePaths {
public:
    struct Path {
        std::vector<Vec3> places;
        PhotonPath seen;
    };
    using Tally = Statistics;

    WholePaths(const PhotonTracer& tracer, const PhotonSpace& space)
        : tracer_(tracer), space_(space) {}

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, Path& path, Statistics& counts) const {
        path = {};
        const auto visit = [&](const Photon& photon) {
            path.places.push_back(photon.position);
            space_.add(photon, path.seen);
            return true;
        };
        count_end(tracer_.trace(read, visit, counts[Count::photon_rays]), counts);
    }

    int height(const Path& path) const { return space_.height(path.seen); }

private:
    const PhotonTracer& tracer_;
    const PhotonSpace& space_;
};

struct GuideSink {
    struct Collector {
        std::vector<Vec3> places;
        void operator()(const WholePaths::Path& path, double) {
            places.insert(places.end(), path.places.begin(), path.places.end());
        }
    };
    Map& map;
    Collector make() { return {}; }
    void take(std::vector<Collector>&& chains) {
        for (const Collector& chain : chains)
            for (const Vec3& place : chain.places) map.add(place, 1);
    }
};

struct Maps {
    const Settings& settings;
    const WholePaths& space;
    PassId id;

    Map uniform() const {
        Map map(settings);
        const IndependentPoints points(id);
        WholePaths::Path path;
        Statistics counts;
        for (std::uint32_t i = 0; i < settings.paths; ++i) {
            space.trace(points.path(i), path, counts);
            for (const Vec3& place : path.places) map.add(place, 1);
        }
        return map;
    }

    /// Fig. 3 of the paper from its start.
    Map paper() const {
        Map map(settings);
        const IndependentPoints points(id);
        PaperState state((PaperSettings()));
        Statistics counts;
        PaperChain<WholePaths> chain(space, true, state, id.stream(Purpose::chain, 0), counts);
        const auto splat = [&](const WholePaths::Path& path, std::uint32_t steps) {
            for (const Vec3& place : path.places) map.add(place, steps);
        };
        StoredSample read;
        WholePaths::Path path;
        const auto take = [&](StoredSample& sample, WholePaths::Path& to) {
            std::swap(sample, read);
            std::swap(to, path);
        };
        for (std::uint32_t i = 0; i < settings.paths; ++i) {
            read.clear();
            space.trace(RecordingReader(points.path(i), read), path, counts);
            chain.step(space.height(path) == kVisible, take, splat, counts);
        }
        chain.finish(splat);
        return map;
    }

    /// States of the last of the first `levels` levels.
    Map set(SplittingPlan plan, std::size_t levels) const {
        plan.levels.resize(levels);
        Map map(settings);
        GuideSink sink{map};
        Statistics counts;
        const EmissionPoints points(id);
        Splitting(space, points, id, plan, {}).run(sink, counts);
        return map;
    }

    /// How many sets a photon at each place would be in.
    Map sets(const SplittingPlan& plan, const VisiblePointOctree& octree) const {
        Map map(settings);
        for (std::size_t i = 0; i < map.cells(); ++i) {
            const int height = octree.height(map.place(i));
            const int visible = height == VisiblePointOctree::kFull ? kVisible : height;
            int sets = 0;
            for (const LevelPlan& level : plan.levels) sets += level.height <= visible ? 1 : 0;
            map.set(i, std::expm1(sets));
        }
        return map;
    }
};

void run(const Settings& settings) {
    const Scene scene(load_scene(settings.scene));
    RenderSettings render;
    const PassId id{0, 0};
    const PassScene pass(scene, id);
    PassImage unused(window_of(scene.film()).pixels(), {});
    Statistics counts;
    const CameraPass camera{pass, render.transport, render.camera, window_of(scene.film()), id, 1};
    const VisiblePointIndex index(trace_camera_paths(camera, unused, counts),
                                  render.transport.max_depth);
    const PhotonTracer tracer(pass, render.transport);
    const VisiblePointOctree octree(index.points(), scene.sphere().center, scene.sphere().radius);
    const PhotonSpace seen(tracer, index, octree);
    const WholePaths space(tracer, seen);
    const Maps maps{settings, space, id};
    render.photon.light_strata = false;
    const SplittingPlan plan = learn_epoch(scene, render, 0).strata.front().plan;
    std::vector<Map> splitting;
    for (std::size_t k = 1; k <= plan.levels.size(); ++k) {
        fmt::print("set {}: height {}\n", k, plan.levels[k - 1].height);
        splitting.push_back(maps.set(plan, k));
    }
    if (splitting.empty())
        throw Error({settings.scene}, "has no splitting", "choose a closer view");
    write_row(settings, "photons", {maps.uniform(), maps.paper(), splitting.back()});
    splitting.pop_back();
    splitting.push_back(maps.sets(plan, octree));
    write_row(settings, "splitting", splitting);
}

}  // namespace
}  // namespace sunfleck::engine::bench

int main(int count, char** words) {
    sunfleck::engine::bench::Settings settings;
    CLI::App app("Pictures of where photons land");
    app.add_option("SCENE", settings.scene, "Scene file")->required();
    app.add_option("-o,--output", settings.folder, "Folder (default: here)");
    app.add_option("--centre", settings.centre, "Middle of the square: x y");
    app.add_option("--width", settings.width, "Of the square");
    app.add_option("--paths", settings.paths, "Uniform ones");
    return sunfleck::engine::bench::run_program(app, count, words,
                                                [&] { sunfleck::engine::bench::run(settings); });
}
