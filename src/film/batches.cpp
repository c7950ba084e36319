// Which batches there are in a set of passes.
#include "film/batches.h"

#include "film/pass_groups.h"
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

CompleteBatches complete_batches(const PassSet& passes) {
    CompleteBatches all;
    for (const PassRange& batch : early_batches(passes)) {
        all.count += 1;
        all.passes += static_cast<double>(batch.size());
    }
    std::uint64_t whole = whole_batches(passes);
    const bool is_first_parted = all.count > 0 && are_all_there(passes, batch_range(0));
    if (is_first_parted) --whole;
    all.count += static_cast<double>(whole);
    all.passes += static_cast<double>(whole * kBatchPasses);
    return all;
}

double area_of(const PassRange& range, double alpha) {
    return mean_area(range.begin, range.end, alpha);
}

std::uint64_t next_batch_end(std::uint64_t pass) {
    return pass < kBatchPasses ? smallest_group(pass).end : batch_range(pass / kBatchPasses).end;
}

}  // namespace sunfleck::engine
