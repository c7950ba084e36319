// Names of statistics, and what they are sums of.
#include "render/count_pass.h"

#include "planning/epoch.h"

#include <string>

namespace sunfleck {
namespace {

/// Level by level, as sums over passes.
void count_ladder(Film& film, const std::string& name, const LadderCounts& ladder) {
    for (std::size_t k = 0; k < ladder.levels.size(); ++k) {
        const std::string level = name + "ladder." + std::to_string(k) + ".";
        const Acceptance mutations = ladder.levels[k].mutations();
        film.count(level + "states", ladder.levels[k].states);
        film.count(level + "survivors", k < ladder.survivors.size() ? ladder.survivors[k] : 0);
        film.count(level + "proposed", mutations.proposed);
        film.count(level + "accepted", mutations.accepted);
    }
}

void count_groups(Film& film, const std::vector<GroupCounts>& groups) {
    if (groups.size() == 1) count_ladder(film, "", groups.front().ladder);
    if (groups.size() < 2) return;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const GroupCounts& group = groups[g];
        const std::string name = "group." + std::to_string(g) + ".";
        film.count(name + "passes", 1);
        film.count(name + "paths", group.paths);
        film.count(name + "starved_passes", group.visible_fraction > 0 ? 0 : 1);
        film.sum(name + "power_share", group.power_share);
        film.sum(name + "visible_fraction", group.visible_fraction);
        count_ladder(film, name, group.ladder);
    }
}

/// How many draws, camera paths and photon paths the passes of an epoch have.
void count_epoch(Film& film, std::uint32_t number, const PassResult& pass) {
    if (pass.groups.empty()) return;
    std::uint64_t paths = 0;
    for (const GroupCounts& group : pass.groups) paths += group.paths;
    const std::string name = "epoch." + std::to_string(epoch_of(number)) + ".";
    film.count(name + "passes", 1);
    film.count(name + "draws", pass.draws);
    film.count(name + "weight", pass.weight);
    film.count(name + "camera_paths", pass.statistics[Count::camera_paths]);
    film.count(name + "paths", paths);
}

bool is_starved(const PassResult& pass) {
    return pass.statistics[Count::visible_states] == 0;
}

}  // namespace

void add_pass(Film& film, std::uint32_t number, const PassResult& pass) {
    film.add_pass(number, pass.image, pass.weight);
    for (const CountRow& row : kCountRows)
        if (row.count != Count::dropped_nonfinite && row.count != Count::saturated)
            film.count(row.name, pass.statistics[row.count]);
    if (pass.statistics[Count::uniform_paths] == 0) return;
    film.count("starved_passes", is_starved(pass) ? 1 : 0);
    film.sum("visible_fraction", pass.visible_fraction);
    film.sum("visible_fraction_square",
             pass.visible_fraction * pass.visible_fraction * kSquareUnits);
    count_epoch(film, number, pass);
    count_groups(film, pass.groups);
}

}  // namespace sunfleck
