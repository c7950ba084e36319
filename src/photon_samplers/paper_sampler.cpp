// One pass of the paper's chain, and its estimate as a difference.
#include "photon_samplers/paper_sampler.h"

#include "core/parallel.h"
#include "estimate/deposit.h"
#include "photon/paper_paths.h"

#include <fmt/format.h>

#include <atomic>

namespace sunfleck::engine {
namespace {

/// What the estimate gained by one pass.
class GainOfPass {
public:
    /// @param state  with the chain as the pass leaves it. @param paths  of the pass.
    GainOfPass(PaperMemory& state, double paths) : state_(state), before_(state.shown) {
        const PaperState& chain = state.chain;
        if (chain.splatted > 0)
            state.shown = chain.visible_fraction() * paths / static_cast<double>(chain.splatted) *
                          static_cast<double>(state.passes);
    }

    /// L_P = UniformCount / i times the mean over splatted paths; terms are rounded alike when they
    /// are added and when they are taken back, so nothing is left of them.
    void add(const PassImage& photons, Aov aov, PassImage& image) {
        std::vector<FixedPoint>& flux = state_.flux.at(static_cast<std::size_t>(aov));
        flux.resize(3 * photons.pixels());
        parallel_blocks(flux.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const FixedPoint shown = scaled(flux[i], before_);
                flux[i] += photons.value(aov, i / 3, i % 3);
                FixedPoint term = scaled(flux[i], state_.shown);
                term += -shown;
                image.add_term(aov, i / 3, i % 3, term);
            }
        });
    }

    std::uint64_t saturated() const { return saturated_; }

private:
    /// A term of the film; cut and counted where it is too large.
    FixedPoint scaled(const FixedPoint& flux, double factor) {
        const double value = flux.to_double() * factor;
        const double term = cut_term(value);
        if (term != value) ++saturated_;
        return FixedPoint::from_double(term);
    }

    PaperMemory& state_;
    double before_;
    std::atomic<std::uint64_t> saturated_{0};
};

/// What the chain counted since the last call.
std::vector<SamplerSum> new_sums(PaperMemory& state) {
    const MutationSize& size = state.chain.size;
    std::vector<SamplerSum> sums = {
        {"mutation_size", size.theta() - state.theta_counted},
        {"theta_floor_held", static_cast<double>(size.floor_held() - state.floor_counted)}};
    state.theta_counted = size.theta();
    state.floor_counted = size.floor_held();
    return sums;
}

AovSet aovs_of(const PassImage& image) {
    AovSet aovs{};
    for (std::size_t i = 0; i < kAovCount; ++i) aovs.at(i) = image.has(kAovs.at(i).aov);
    return aovs;
}

}  // namespace

std::string PaperSampler::settings_text(const PhotonSettings& settings) {
    const PaperSettings& paper = settings.paper;
    return fmt::format(
        "replica_exchange={}\nmutation_size={}\ntarget_acceptance={}\n",
        paper.replica_exchange ? "on" : "off",
        paper.mutation_size ? fmt::format("{}", *paper.mutation_size) : std::string("adaptive"),
        paper.target_acceptance);
}

PhotonTotals PaperSampler::trace(const PhotonPass& pass, const PhotonTarget& target, State& state) {
    ++state.passes;
    const auto paths = static_cast<std::uint32_t>(paths_of(pass.strata));
    if (paths == 0) return {};
    const PhotonContext& photon_context = pass.photon_context;
    PassImage photons(target.image.pixels(), aovs_of(target.image));
    PhotonCounts here(target.taken == nullptr ? photons.pixels() : 0);
    PhotonCounts& taken = target.taken == nullptr ? here : *target.taken;
    const Depositor deposit(photon_context.scene, photon_context.index, photons, paths, &taken);
    PhotonTotals totals;
    totals.statistics =
        trace_paper_paths(photon_context, {pass.id, paths, pass.settings.paper.replica_exchange},
                          state.chain, deposit);
    state.radii.add(taken);
    GainOfPass gain(state, paths);
    for (const AovRow& row : kAovs)
        if (photons.has(row.aov)) gain.add(photons, row.aov, target.image);
    totals.statistics[Count::dropped_nonfinite] += photons.dropped();
    totals.statistics[Count::saturated] += photons.saturated() + gain.saturated();
    totals.visible_fraction =
        static_cast<double>(totals.statistics[Count::uniform_visible]) / paths;
    totals.sums = new_sums(state);
    return totals;
}

}  // namespace sunfleck::engine
