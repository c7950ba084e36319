// StoredSample: a primary sample whose dimensions are drawn when they are first read, with its
// readers.
//
// In:  dimensions that a path reads. Out: the same values again, and mutated copies of the sample.
// A dimension that no path has read is never drawn, because visibility does not depend on it
// (docs/method/sampling.md).
#pragma once

#include "chains/mutation.h"
#include "random_numbers/primary_sample.h"

#include <vector>

namespace sunfleck::engine {

class StoredSample {
public:
    bool has(std::uint32_t dimension) const {
        return dimension < values_.size() &&
               ((read_[dimension / 64] >> (dimension % 64)) & 1U) != 0;
    }
    /// @param dimension  one that was read.
    std::uint64_t operator[](std::uint32_t dimension) const { return values_[dimension]; }

    void set(std::uint32_t dimension, std::uint64_t value) {
        if (dimension >= values_.size()) grow(dimension);
        values_[dimension] = value;
        read_[dimension / 64] |= std::uint64_t{1} << (dimension % 64);
    }
    /// Removes all dimensions and keeps the memory.
    void clear() {
        values_.clear();
        read_.clear();
    }

    friend bool operator==(const StoredSample&, const StoredSample&) = default;

    /// Passes all data to archive(...), for writing or reading (render/checkpoint.h).
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.values_, self.read_);
    }
    /// Returns whether the data that an archive filled in are consistent.
    bool is_sound() const { return read_.size() == (values_.size() + 63) / 64; }

private:
    /// Allocates the dimension and the next ones, which paths read soon.
    [[gnu::noinline]] void grow(std::uint32_t dimension) {
        constexpr std::uint32_t kAtOnce = 16;  // divides 64
        values_.resize((dimension / kAtOnce + 1) * kAtOnce);
        read_.resize(dimension / 64 + 1);
    }

    std::vector<std::uint64_t> values_;
    std::vector<std::uint64_t> read_;  // one bit per dimension
};

/// Records what another reader returns.
template <PrimarySampleReader Source>
class RecordingReader {
public:
    /// @param to  target; empty.
    RecordingReader(Source source, StoredSample& to) : source_(source), to_(to) {}

    std::uint64_t operator()(std::uint32_t dimension) {
        if (!to_.has(dimension)) to_.set(dimension, source_(dimension));
        return to_[dimension];
    }

private:
    Source source_;
    StoredSample& to_;
};

/// Reads a sample again. Missing dimensions are drawn; a path that was traced from it before has
/// none.
class RepeatingReader {
public:
    RepeatingReader(StoredSample& sample, RandomStream& stream)
        : sample_(sample), stream_(stream) {}

    std::uint64_t operator()(std::uint32_t dimension) {
        if (!sample_.has(dimension)) sample_.set(dimension, stream_.next_fraction());
        return sample_[dimension];
    }

private:
    StoredSample& sample_;
    RandomStream& stream_;
};

/// Mutates dimensions that the parent has read; others are drawn. Dimensions that only the parent
/// has read are dropped.
/// @tparam Move  move(dimension number, value) -> new value, symmetric.
template <class Move>
class MutatingReader {
public:
    /// @param to  the new sample; empty.
    MutatingReader(const StoredSample& parent, StoredSample& to, RandomStream& stream, Move move)
        : parent_(parent), to_(to), stream_(stream), move_(move) {}

    std::uint64_t operator()(std::uint32_t dimension) {
        if (!to_.has(dimension))
            to_.set(dimension, parent_.has(dimension) ? move_(dimension, parent_[dimension])
                                                      : stream_.next_fraction());
        return to_[dimension];
    }

private:
    const StoredSample& parent_;
    StoredSample& to_;
    RandomStream& stream_;
    Move move_;
};

}  // namespace sunfleck::engine
