// Addition of passes, completion of batches, merging of films.
#include "film/film.h"

#include "film/luminance.h"
#include "film/pass_groups.h"
#include "film/pass_terms.h"
#include "film/pass_weight.h"
#include "math/wavelengths.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Adds each term to its sum. @param terms  empty, or as many arrays of the same sizes.
void add_all(const std::vector<std::span<FixedPoint>>& sums,
             const std::vector<std::span<const FixedPoint>>& terms) {
    for (std::size_t i = 0; i < terms.size(); ++i) add_all(sums[i], terms[i]);
}

void check_image(const FilmKey& key, std::uint32_t number, const PassImage& image) {
    const SourceLocation where{"pass " + std::to_string(number)};
    if (image.pixels() != key.pixels())
        throw Error(where,
                    "has " + std::to_string(image.pixels()) + " pixels, the film " +
                        std::to_string(key.pixels()),
                    "render it at the film's resolution");
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (key.has(i) && !image.has(kAovs.at(i).aov))
            throw Error(where, "lacks the AOV \"" + std::string(kAovs.at(i).name) + "\"",
                        "render it with the film's AOVs and light groups");
    if (image.light_groups() != key.light_groups.size())
        throw Error(where,
                    "has " + std::to_string(image.light_groups()) + " light groups, the film " +
                        std::to_string(key.light_groups.size()),
                    "render it with the film's AOVs and light groups");
    if (key.has_discs() && image.photon_cells() != photon_cells_of(key).count())
        throw Error(where, "does not store photons' light apart", "add it to a film without discs");
}

std::string text_of(const PassRange& range) {
    return std::to_string(range.begin) + ":" + std::to_string(range.end);
}

/// Checks that both belong to one render and have no common pass.
void check_parts(const FilmSums& sums, const FilmSums& other, const std::string& other_name) {
    if (const auto differs = difference(sums.key, other.key)) {
        const std::string values =
            differs->here.empty() ? "" : ": " + differs->here + " and " + differs->there;
        throw Error({other_name}, "is of another render: " + differs->what + " differs" + values,
                    "merge films of one render");
    }
    if (sums.key.sequential)
        throw Error({other_name},
                    "its passes depend on each other, so that films of them cannot be merged",
                    "render with another --photon-sampler to merge");
    for (const PassRange& range : other.passes.ranges())
        if (sums.passes.count_in(range) != 0)
            throw Error({other_name}, "passes " + text_of(range) + " overlap those of another film",
                        "render disjoint passes with --pass-range");
}

/// @param sums  of all passes or of an open batch; arrays of AOVs that are not kept are empty.
template <class Sums>
void add_aovs(Sums& sums, const WeighedImage& pass) {
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (!sums.aovs.at(i).empty()) add_aov(sums.aovs.at(i), pass, kAovs.at(i));
    for (std::size_t i = 0; i < sums.light_groups.size(); ++i)
        add_light_group(sums.light_groups[i], pass, i);
}

}  // namespace

Film::Film(FilmKey key) : sums_(empty_sums(std::move(key))) {}

CompleteBatches Film::batches() const {
    return key().sequential ? CompleteBatches() : complete_batches(key(), sums_.passes);
}

double Film::weight() const {
    return weight_in(key(), sums_.passes, {0, ~std::uint64_t{0}});
}

double Film::share_of_pass(std::uint64_t number) const {
    const PassSet& passes = sums_.passes;
    if (whole_batches(passes) > 0) return share_of_group(passes, group_of(passes, number));
    const auto held = [&](std::uint64_t pass) {
        return passes.count_in(batch_range(pass / kBatchPasses));
    };
    std::uint64_t most = 0;
    for (const auto& [first, group] : sums_.open_groups) most = std::max(most, held(first));
    return static_cast<double>(held(number)) / static_cast<double>(most);
}

double Film::passes_in_picture() const {
    double sum = weight();
    for (const auto& [first, group] : sums_.open_groups)
        sum -= (1 - share_of_pass(first)) *
               weight_in(key(), sums_.passes, group_of(sums_.passes, first));
    return sum;
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

void Film::add_pass(std::uint32_t number, const PassImage& image) {
    const PassRange range{number, std::uint64_t{number} + 1};
    if (sums_.passes.count_in(range) != 0)
        throw Error({"pass " + std::to_string(number)}, "the film already contains it",
                    "add each pass once");
    check_image(sums_.key, number, image);
    const WeighedImage weighed{image, bits_less(key(), number)};
    add_aovs(sums_, weighed);
    count("dropped_nonfinite", image.dropped());
    count("saturated", image.saturated());
    const std::vector<PassRange> early = early_batches(sums_.passes);
    sums_.passes.insert(range);
    if (key().sequential) return;
    const auto [place, is_new] = sums_.open_groups.try_emplace(smallest_group(number).begin);
    OpenGroup& group = place->second;
    if (is_new) group = empty_group(key());
    add_aovs(group, weighed);
    if (key().has_discs()) {
        const double area = area_of(key(), batch_range(number / kBatchPasses));
        count("saturated", add_photons(sums_, weighed, area, group));
    }
    close_early_batches(early);
    join_groups();
    close_batches();
}

/// Adds sums of passes of one group. @param first  its first pass.
void Film::add_group(std::uint64_t first, OpenGroup group) {
    const auto [place, is_new] = sums_.open_groups.try_emplace(first, std::move(group));
    if (is_new) return;
    add_all(arrays(place->second), arrays(std::as_const(group)));
}

/// Adds early batches that passes have completed. Their groups are not joined yet.
/// @param before  those that are added.
void Film::close_early_batches(const std::vector<PassRange>& before) {
    EarlySums& early = sums_.early;
    if (early.pixel_squares.empty()) early = empty_early_sums(key(), sums_.passes);
    for (const PassRange& batch : early_batches(sums_.passes)) {
        if (std::find(before.begin(), before.end(), batch) != before.end()) continue;
        const OpenGroup& group = sums_.open_groups.at(batch.begin);
        const double passes = weight_in(key(), batch);
        add_squares(key(), group, passes, passes, squares_of_early(sums_));
        if (key().has_discs())
            add_early_area(sums_, group, area_of(key(), batch) - area_of(key(), batch_range(0)));
    }
}

/// Merges groups after passes were added.
void Film::join_groups() {
    for (auto& [first, group] : std::exchange(sums_.open_groups, {}))
        add_group(group_of(sums_.passes, first).begin, std::move(group));
}

void Film::close_batches() {
    const bool are_early = has_early_batches(sums_.passes);
    for (auto group = sums_.open_groups.begin(); group != sums_.open_groups.end();) {
        const std::uint64_t batch = group->first / kBatchPasses;
        const bool complete = sums_.passes.count_in(batch_range(batch)) == kBatchPasses;
        if (complete) {
            const double passes = weight_in(key(), batch_range(batch));
            const auto add = [&](double factor, const SquareSums& sums) {
                return add_squares(key(), group->second, passes, factor, sums);
            };
            count("saturated_squares", add(passes / kBatchPasses, squares_of_whole(sums_)));
            if (batch == 0 && are_early) add(-passes, squares_of_early(sums_));
        }
        group = complete ? sums_.open_groups.erase(group) : std::next(group);
    }
    if (!are_early) sums_.early = {};
}

void Film::merge(const Film& other, const std::string& other_name) {
    const FilmSums& from = other.sums_;
    check_parts(sums_, from, other_name);
    add_all(total_arrays(sums_), total_arrays(from));
    for (const auto& [name, value] : from.statistics) sums_.statistics[name] += value;
    std::vector<PassRange> early = early_batches(sums_.passes);
    for (const PassRange& batch : early_batches(from.passes)) early.push_back(batch);
    for (const PassRange& range : from.passes.ranges()) sums_.passes.insert(range);
    if (sums_.early.pixel_squares.empty())
        sums_.early = from.early;
    else
        add_all(arrays(sums_.early), arrays(from.early));
    for (const auto& [first, group] : from.open_groups) add_group(first, group);
    close_early_batches(early);
    join_groups();
    close_batches();
}

}  // namespace sunfleck::engine
