// Uniform paths of each stratum.
#include "photon_samplers/uniform_sampler.h"

#include "estimate/deposit.h"

#include <algorithm>

namespace sunfleck::engine {

std::uint32_t usual_photon_paths(std::size_t pixels) {
    constexpr std::size_t kLeast = 200'000;
    constexpr std::size_t kOfPixel = 2;
    constexpr std::size_t kMost = std::size_t{1} << 30U;
    return static_cast<std::uint32_t>(std::min(kMost, std::max(kLeast, kOfPixel * pixels)));
}

double count_uniform(Statistics& counts, Statistics& all) {
    const std::uint64_t visible = counts[Count::uniform_visible];
    counts[Count::distinct_visible] = counts[Count::visible_states] = visible;
    all += counts;
    return static_cast<double>(visible) / static_cast<double>(counts[Count::uniform_paths]);
}

double trace_uniform_stratum(const PhotonPass& pass, UniformKind kind, const LightStratum& stratum,
                             const PhotonTarget& target, PhotonTotals& totals) {
    const PhotonContext& view = pass.view;
    const PhotonTracer tracer(view.scene, view.transport, stratum.lights);
    const std::uint32_t paths = stratum.plan.uniform_paths;
    const Depositor deposit(view.scene, view.index, target.image, paths, target.taken);
    Statistics counts = trace_uniform_paths(
        tracer, {kind, pass.id.with_part(stratum.part), paths},
        [&](const Photon& photon) { return view.index.may_accept(photon); }, deposit);
    return count_uniform(counts, totals.statistics);
}

PhotonTotals trace_uniform_strata(const PhotonPass& pass, UniformKind kind,
                                  const PhotonTarget& target) {
    PhotonTotals totals;
    for (const LightStratum& stratum : pass.strata) {
        StratumCounts counts{stratum.paths(), stratum.power_share, 0, {}};
        counts.visible_fraction = trace_uniform_stratum(pass, kind, stratum, target, totals);
        totals.add_stratum(std::move(counts));
    }
    return totals;
}

}  // namespace sunfleck::engine
