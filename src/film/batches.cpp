// Which batches there are in a set of passes.
#include "film/batches.h"

#include "film/pass_groups.h"
#include "film/pass_weight.h"
#include "math/wavelengths.h"
#include "visible_points/radius.h"

namespace sunfleck::engine {
namespace {

bool are_all_there(const PassSet& passes, const PassRange& range) {
    return passes.count_in(range) == range.size();
}

}  // namespace

PassRange batch_range(std::uint64_t batch) {
    return {batch * kBatchPasses, (batch + 1) * kBatchPasses};
}

std::uint64_t whole_batches(const PassSet& passes) {
    std::uint64_t batches = 0;
    for (const PassRange& range : passes.ranges()) {
        const std::uint64_t first = (range.begin + kBatchPasses - 1) / kBatchPasses;
        const std::uint64_t end = range.end / kBatchPasses;
        if (end > first) batches += end - first;
    }
    return batches;
}

bool has_early_batches(const PassSet& passes) {
    return passes.count_in(batch_range(0)) > 0 && whole_batches(passes) < kWholeBatches;
}

std::vector<PassRange> early_batches(const PassSet& passes) {
    std::vector<PassRange> batches;
    if (!has_early_batches(passes)) return batches;
    for (std::uint64_t pass = 0; pass < kBatchPasses; pass = smallest_group(pass).end)
        if (are_all_there(passes, smallest_group(pass))) batches.push_back(smallest_group(pass));
    return batches;
}

bool is_early(const PassSet& passes, const PassRange& group) {
    return group.end <= kBatchPasses && has_early_batches(passes) && are_all_there(passes, group);
}

CompleteBatches complete_batches(const FilmKey& key, const PassSet& passes) {
    std::vector<PassRange> first = early_batches(passes);
    std::uint64_t others = whole_batches(passes);
    if (are_all_there(passes, batch_range(0))) {
        --others;
        if (first.empty()) first.push_back(batch_range(0));
    }
    CompleteBatches all{static_cast<double>(first.size() + others),
                        static_cast<double>(others * kBatchPasses)};
    for (const PassRange& batch : first) all.passes += weight_in(key, batch);
    return all;
}

double area_of(const FilmKey& key, const PassRange& range) {
    DiscAreaSequence areas(key.alpha);
    for (std::uint64_t pass = 0; pass < range.begin; ++pass) areas.next();
    double sum = 0;
    for (std::uint64_t pass = range.begin; pass < range.end; ++pass)
        sum += weight_of(key, pass) * areas.next();
    return sum / weight_in(key, range);
}

std::uint64_t next_batch_end(std::uint64_t pass) {
    return pass < kBatchPasses ? smallest_group(pass).end : batch_range(pass / kBatchPasses).end;
}

}  // namespace sunfleck::engine
