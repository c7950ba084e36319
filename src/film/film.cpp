// Adding passes, folding complete rounds, merging films.
#include "film/film.h"

#include "core/error.h"
#include "film/pass_terms.h"
#include "math/wavelengths.h"
#include "measurement/radius.h"

#include <utility>

namespace sunfleck {
namespace {

void check_image(const FilmKey& key, std::uint32_t number, const PassImage& image) {
    const SourceLocation where{"pass " + std::to_string(number)};
    if (image.pixels() != key.pixels())
        throw Error(where,
                    "has " + std::to_string(image.pixels()) + " pixels, the film " +
                        std::to_string(key.pixels()),
                    "render it at the film's resolution");
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i) && !image.has(kLayers.at(i).layer))
            throw Error(where, "lacks the layer \"" + std::string(kLayers.at(i).name) + "\"",
                        "render it with the film's layers");
    if (image.light_layers() != key.light_layers.size())
        throw Error(where,
                    "has " + std::to_string(image.light_layers()) + " layers of lights, the film " +
                        std::to_string(key.light_layers.size()),
                    "render it with the film's layers");
    if (key.has_discs() && !image.photons_apart())
        throw Error(where, "does not hold apart what photons have brought",
                    "add it to a film without discs");
}

}  // namespace

PassRange round_range(std::uint64_t round) {
    return {round * kRoundPasses, (round + 1) * kRoundPasses};
}

std::uint64_t complete_rounds(const PassSet& passes) {
    std::uint64_t rounds = 0;
    for (const PassRange& range : passes.ranges()) {
        const std::uint64_t first = (range.begin + kRoundPasses - 1) / kRoundPasses;
        const std::uint64_t end = range.end / kRoundPasses;
        if (end > first) rounds += end - first;
    }
    return rounds;
}

std::vector<std::uint64_t> open_rounds(const PassSet& passes) {
    std::vector<std::uint64_t> open;
    const auto add = [&](std::uint64_t round) {
        const std::uint64_t held = passes.count_in(round_range(round));
        const bool known = !open.empty() && open.back() == round;
        if (held > 0 && held < kRoundPasses && !known) open.push_back(round);
    };
    for (const PassRange& range : passes.ranges()) {
        add(range.begin / kRoundPasses);
        add((range.end - 1) / kRoundPasses);
    }
    return open;
}

Film::Film(FilmKey key) : sums_(empty_sums(std::move(key))) {}

std::uint64_t Film::rounds() const {
    return key().sequential ? 0 : complete_rounds(sums_.passes);
}

double Film::weight() const {
    std::uint64_t weight = pass_count();
    for (const auto& [times, passes] : sums_.heavy) weight += (times - 1) * passes.count();
    return static_cast<double>(weight);
}

double Film::weight_of_rounds() const {
    std::uint64_t weight = rounds();
    for (const auto& [times, passes] : sums_.heavy) weight += (times - 1) * complete_rounds(passes);
    return static_cast<double>(weight);
}

std::uint32_t Film::weight_of_round(std::uint64_t round) const {
    for (const auto& [times, passes] : sums_.heavy)
        if (passes.count_in(round_range(round)) > 0) return times;
    return 1;
}

void Film::count(std::string_view name, std::uint64_t events) {
    if (events == 0) return;
    sums_.statistics[std::string(name)] += FixedPoint{static_cast<std::int64_t>(events), 0};
}

void Film::sum(std::string_view name, double x) {
    const double cut = cut_term(x);
    if (cut != 0) sums_.statistics[std::string(name)] += FixedPoint::from_double(cut);
}

double Film::statistic(std::string_view name) const {
    const auto found = sums_.statistics.find(name);
    return found == sums_.statistics.end() ? 0 : found->second.to_double();
}

void Film::add_pass(std::uint32_t number, const PassImage& image, std::uint32_t weight) {
    const PassRange range{number, std::uint64_t{number} + 1};
    if (sums_.passes.count_in(range) != 0)
        throw Error({"pass " + std::to_string(number)}, "the film holds it already",
                    "add each pass once");
    check_image(sums_.key, number, image);
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key().has(i)) add_layer(sums_.layers.at(i), image, kLayers.at(i), weight);
    for (std::size_t i = 0; i < sums_.light_layers.size(); ++i)
        add_light_layer(sums_.light_layers[i], image, i, weight);
    count("dropped_nonfinite", image.dropped());
    count("saturated", image.saturated());
    sums_.passes.insert(range);
    if (weight > 1) sums_.heavy[weight].insert(range);
    if (key().sequential) return;
    OpenRound& round = open_round(number / kRoundPasses);
    add_layer(round.rgb, image, kLayers[0], weight);
    if (key().has_discs()) {
        const double area = round_area(number / kRoundPasses, key().alpha);
        count("saturated", add_photons(sums_, image, {area, weight}, round));
    }
    close_rounds();
}

OpenRound& Film::open_round(std::uint64_t number) {
    const auto [round, is_new] = sums_.open_rounds.try_emplace(number);
    if (is_new) round->second = empty_round(key());
    return round->second;
}

void Film::close_rounds() {
    for (auto round = sums_.open_rounds.begin(); round != sums_.open_rounds.end();) {
        const bool complete = sums_.passes.count_in(round_range(round->first)) == kRoundPasses;
        if (complete)
            count("saturated_squares",
                  add_squares(sums_, round->second, weight_of_round(round->first)));
        round = complete ? sums_.open_rounds.erase(round) : std::next(round);
    }
}

void Film::merge(const Film& other, const std::string& other_name) {
    const FilmSums& from = other.sums_;
    if (const auto differs = difference(sums_.key, from.key)) {
        const std::string values =
            differs->here.empty() ? "" : ": " + differs->here + " and " + differs->there;
        throw Error({other_name}, "is of another render: " + differs->what + " differs" + values,
                    "merge parts of one render alone");
    }
    if (key().sequential)
        throw Error({other_name}, "its passes build on one another and are no parts of a render",
                    "render with another --photon-sampler to merge");
    for (const PassRange& range : from.passes.ranges())
        if (sums_.passes.count_in(range) != 0)
            throw Error({other_name},
                        "passes " + std::to_string(range.begin) + ":" + std::to_string(range.end) +
                            " are in another part, too, some or all",
                        "give each part passes of its own with --pass-range");
    const auto sums = total_arrays(sums_);
    const auto terms = total_arrays(from);
    for (std::size_t i = 0; i < sums.size(); ++i) add_all(sums[i], terms[i]);
    for (const auto& [number, other_round] : from.open_rounds) {
        const auto round = arrays(open_round(number));
        for (std::size_t i = 0; i < round.size(); ++i) add_all(round[i], arrays(other_round)[i]);
    }
    for (const auto& [name, value] : from.statistics) sums_.statistics[name] += value;
    for (const PassRange& range : from.passes.ranges()) sums_.passes.insert(range);
    for (const auto& [weight, passes] : from.heavy)
        for (const PassRange& range : passes.ranges()) sums_.heavy[weight].insert(range);
    close_rounds();
}

}  // namespace sunfleck
