// The stages of one pass around the paper's chain, and its estimate as a difference.
#include "paper/paper_render.h"

#include "camera_paths/trace_camera_paths.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "estimate/deposit.h"
#include "photon/paper_paths.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Section 7.
constexpr std::uint32_t kPathsPerPass = 200'000;

}  // namespace

PaperRender::PaperRender(const Scene& scene, const RenderSettings& settings, PaperMemory& memory)
    : scene_(scene),
      settings_(settings),
      window_(window_of(scene.film())),
      paths_(settings.photon.paths_per_pass.value_or(kPathsPerPass)),
      memory_(memory) {}

PassResult PaperRender::next_pass() {
    const PassId id{settings_.seed, static_cast<std::uint32_t>(memory_.passes++)};
    const std::size_t pixels = window_.pixels();
    PassResult result{PassImage(pixels, settings_.aovs), {}, {}, 1, 0, {}};
    Stopwatch watch;
    const PassScene scene(scene_, id);
    result.seconds.build = watch.lap();
    auto points = trace_camera_paths({scene, settings_.transport, settings_.camera, window_, id, 1},
                                     result.image, result.statistics);
    memory_.radii.shrink(points);
    result.radius_factor = memory_.radii.mean_factor();
    result.seconds.camera = watch.lap();
    const VisiblePointIndex index(std::move(points), settings_.transport.max_depth);
    result.seconds.index = watch.lap();
    PassImage photons(pixels, settings_.aovs);
    PhotonCounts taken(pixels);
    const Depositor deposit(scene, index, photons, paths_, &taken);
    const Statistics counts = trace_paper_paths(
        {scene, settings_.transport, index}, {id, paths_, settings_.photon.paper.replica_exchange},
        memory_.chain, deposit);
    memory_.radii.add(taken);
    if (result.image.has(Aov::samples)) add_samples(taken, result.image);
    add_photon_light(photons, result.image);
    result.seconds.photon = watch.lap();
    result.statistics += counts;
    result.visible_fraction = static_cast<double>(counts[Count::uniform_visible]) / paths_;
    dropped_ = photons.dropped();
    saturated_ += photons.saturated();
    return result;
}

/// A term of the film; cut and counted where it is too large.
FixedPoint PaperRender::scaled(const FixedPoint& flux, double factor) {
    const double value = flux.to_double() * factor;
    const double term = cut_term(value);
    if (term != value) ++saturated_;
    return FixedPoint::from_double(term);
}

/// L_P = UniformCount / i times the mean over splatted paths; terms are rounded alike when they are
/// added and when they are taken back, so nothing is left of them.
void PaperRender::add_photon_light(const PassImage& photons, PassImage& image) {
    const PaperState& chain = memory_.chain;
    const double before = memory_.shown;
    if (chain.splatted > 0)
        memory_.shown = chain.visible_fraction() * paths_ / static_cast<double>(chain.splatted) *
                        static_cast<double>(memory_.passes);
    for (std::size_t l = 0; l < kAovCount; ++l) {
        const Aov aov = kAovs.at(l).aov;
        if (!photons.has(aov)) continue;
        FixedPoints& flux = memory_.flux.at(l);
        flux.resize(3 * photons.pixels());
        const auto add = [&](std::size_t i) {
            const FixedPoint shown = scaled(flux[i], before);
            flux[i] += photons.value(aov, i / 3, i % 3);
            FixedPoint term = scaled(flux[i], memory_.shown);
            term += -shown;
            image.add_term(aov, i / 3, i % 3, term);
        };
        parallel_blocks(flux.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) add(i);
        });
    }
}

void PaperRender::count(Film& film) {
    film.count("dropped_nonfinite", dropped_);
    film.count("saturated", saturated_.exchange(0));
    const MutationSize& size = memory_.chain.size;
    film.sum("mutation_size", size.theta() - memory_.theta_counted);
    film.count("theta_floor_held", size.floor_held() - memory_.floor_counted);
    memory_.theta_counted = size.theta();
    memory_.floor_counted = size.floor_held();
}

}  // namespace sunfleck::engine
