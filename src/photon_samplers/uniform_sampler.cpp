// Uniform paths of each stratum.
#include "photon_samplers/uniform_sampler.h"

#include "estimate/deposit.h"
#include "guide/guided_points.h"
#include "random_numbers/emission_points.h"

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

namespace {

template <class Points>
TracedPaths traced(const PhotonPass& pass, const LightStratum& stratum, const Points& points,
                   std::uint32_t paths, const PhotonTarget& target) {
    const PhotonContext& context = pass.photon_context;
    const PhotonTracer tracer(context.scene, context.transport, stratum.lights);
    const Depositor deposit(context.scene, context.index, target.image, paths, target.taken);
    return trace_independent_paths(
        tracer, points, paths,
        [&](const Photon& photon) { return context.index.may_accept(photon); }, deposit);
}

}  // namespace

double trace_uniform_stratum(const PhotonPass& pass, UniformKind kind, const LightStratum& stratum,
                             const PhotonTarget& target, PhotonTotals& totals) {
    const PassId id = pass.id.with_stratum(stratum.number);
    const std::uint32_t paths = stratum.plan.uniform_paths;
    TracedPaths done = kind == UniformKind::uniform
                           ? traced(pass, stratum, EmissionPoints(id), paths, target)
                           : traced(pass, stratum, IndependentPoints(id), paths, target);
    done.statistics[Count::uniform_paths] = paths;
    done.statistics[Count::uniform_visible] = done.visible;
    return count_uniform(done.statistics, totals.statistics);
}

TracedPaths trace_guided_paths(const PhotonPass& pass, const LightStratum& stratum,
                               const PhotonTarget& target, PhotonTotals& totals) {
    const GuidedPlan& guided = stratum.guided;
    const GuidedPoints points(pass.id.with_stratum(stratum.number), guided.map, guided.most_weight);
    TracedPaths done = traced(pass, stratum, points, guided.paths, target);
    totals.statistics += done.statistics;
    totals.statistics[Count::guided_paths] += guided.paths;
    for (const Count count :
         {Count::guided_visible, Count::distinct_visible, Count::visible_states})
        totals.statistics[count] += done.visible;
    return done;
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
