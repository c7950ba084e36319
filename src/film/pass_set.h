// Which passes a film holds: ranges of numbers, joined wherever they touch.
#pragma once

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Passes begin, begin + 1, ... end - 1.
struct PassRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;

    std::uint64_t size() const { return end - begin; }
    friend bool operator==(const PassRange&, const PassRange&) = default;
};

/// A set with one form for one content: ranges ascend, none is empty, none touches the next.
class PassSet {
public:
    /// @param range  not empty, none of it in the set.
    void insert(const PassRange& range);

    /// How many passes of [range.begin, range.end) are in the set.
    std::uint64_t count_in(const PassRange& range) const;

    std::uint64_t count() const { return count_in({0, ~std::uint64_t{0}}); }
    const std::vector<PassRange>& ranges() const { return ranges_; }
    friend bool operator==(const PassSet&, const PassSet&) = default;

private:
    std::vector<PassRange> ranges_;
};

}  // namespace sunfleck::engine
