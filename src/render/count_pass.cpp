// Names of statistics, and the sums behind them.
#include "render/count_pass.h"

#include "planning/epoch.h"

#include <string>

namespace sunfleck::engine {
namespace {

/// Passes whose camera paths bring indirect light: all of a render, or none.
constexpr const char* kIndirectSampled = "indirect_sampled";

/// Counts the independent paths that chains descend from. Where few bring all light, or one brings
/// most of it, the noise of a pass is theirs.
void count_lineages(Film& film, const std::string& name, const Lineages& lineages) {
    constexpr std::uint64_t kFew = 16;
    film.count(name + "runs", 1);
    film.count(name + "fewer_than_16", lineages.count < kFew ? 1 : 0);
    film.count(name + "one_has_half", lineages.largest_share > 0.5 ? 1 : 0);
    film.sum(name + "largest_share", lineages.largest_share);
}

/// Counts level by level, as sums over passes.
void count_splitting(Film& film, const std::string& name, const SplittingCounts& splitting) {
    for (std::size_t k = 0; k < splitting.levels.size(); ++k) {
        const std::string level = name + "splitting." + std::to_string(k) + ".";
        const Acceptance mutations = splitting.levels[k].mutations();
        film.count(level + "states", splitting.levels[k].states);
        film.count(level + "survivors",
                   k < splitting.survivors.size() ? splitting.survivors[k] : 0);
        film.count(level + "proposed", mutations.proposed);
        film.count(level + "accepted", mutations.accepted);
    }
    if (splitting.lineages) count_lineages(film, name + "lineages.", *splitting.lineages);
}

void count_strata(Film& film, const std::vector<StratumCounts>& strata) {
    if (strata.size() == 1) count_splitting(film, "", strata.front().splitting);
    if (strata.size() < 2) return;
    for (std::size_t g = 0; g < strata.size(); ++g) {
        const StratumCounts& stratum = strata[g];
        const std::string name = "stratum." + std::to_string(g) + ".";
        film.count(name + "passes", 1);
        film.count(name + "paths", stratum.paths);
        film.count(name + "starved_passes", stratum.visible_fraction > 0 ? 0 : 1);
        film.sum(name + "power_share", stratum.power_share);
        film.sum(name + "visible_fraction", stratum.visible_fraction);
        count_splitting(film, name, stratum.splitting);
    }
}

/// Counts camera paths and photon paths of an epoch's passes.
void count_epoch(Film& film, std::uint32_t number, const PassResult& pass) {
    if (pass.strata.empty()) return;
    std::uint64_t paths = 0;
    for (const StratumCounts& stratum : pass.strata) paths += stratum.paths;
    const std::string name = "epoch." + std::to_string(epoch_of(number)) + ".";
    film.count(name + "passes", 1);
    film.count(name + "camera_paths", pass.statistics[Count::camera_paths]);
    film.count(name + "paths", paths);
}

/// What Film::add_pass() counts by itself.
std::uint64_t counted_by_film(const PassImage& image, Count count) {
    if (count == Count::dropped_nonfinite) return image.dropped();
    return count == Count::saturated ? image.saturated() : 0;
}

bool is_starved(const PassResult& pass) {
    return pass.statistics[Count::visible_states] == 0;
}

}  // namespace

void add_pass(Film& film, std::uint32_t number, const PassResult& pass) {
    film.add_pass(number, pass.image);
    for (const CountRow& row : kCountRows)
        film.count(row.name, pass.statistics[row.count] - counted_by_film(pass.image, row.count));
    for (const SamplerSum& sum : pass.sums) film.sum(sum.name, sum.value);
    if (pass.statistics[Count::uniform_paths] + pass.statistics[Count::guided_paths] == 0) return;
    film.count("starved_passes", is_starved(pass) ? 1 : 0);
    film.count(kIndirectSampled, pass.indirect == IndirectLight::sampled ? 1 : 0);
    film.sum("visible_fraction", pass.visible_fraction);
    film.sum("visible_fraction_square",
             pass.visible_fraction * pass.visible_fraction * kSquareUnits);
    count_epoch(film, number, pass);
    count_strata(film, pass.strata);
}

IndirectLight indirect_of(const Film& film) {
    return film.statistic(kIndirectSampled) > 0 ? IndirectLight::sampled : IndirectLight::photons;
}

}  // namespace sunfleck::engine
