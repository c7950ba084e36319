// Inserting into a set of ranges, and counting in it.
#include "film/pass_set.h"

#include <algorithm>

namespace sunfleck::engine {

void PassSet::insert(const PassRange& range) {
    auto next =
        std::lower_bound(ranges_.begin(), ranges_.end(), range,
                         [](const PassRange& a, const PassRange& b) { return a.begin < b.begin; });
    next = ranges_.insert(next, range);
    if (next + 1 != ranges_.end() && next->end == (next + 1)->begin) {
        next->end = (next + 1)->end;
        ranges_.erase(next + 1);
    }
    if (next != ranges_.begin() && (next - 1)->end == next->begin) {
        (next - 1)->end = next->end;
        ranges_.erase(next);
    }
}

std::uint64_t PassSet::count_in(const PassRange& range) const {
    auto r = std::upper_bound(ranges_.begin(), ranges_.end(), range.begin,
                              [](std::uint64_t pass, const PassRange& a) { return pass < a.end; });
    std::uint64_t count = 0;
    for (; r != ranges_.end() && r->begin < range.end; ++r)
        count += std::min(r->end, range.end) - std::max(r->begin, range.begin);
    return count;
}

}  // namespace sunfleck::engine
