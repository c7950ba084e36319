// A primary sample whose dimensions exist once they were read, and the readers that fill it.
//
// In:  the numbers that a path asks for. Out: the same numbers again, and copies of the sample
// in which the dimensions that were read have moved a little. A dimension that no path has read is
// never drawn: whether a path is visible does not depend on it (docs/method/method.md).
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
    /// @param dimension  one that it has.
    std::uint64_t operator[](std::uint32_t dimension) const { return values_[dimension]; }

    void set(std::uint32_t dimension, std::uint64_t value) {
        if (dimension >= values_.size()) grow(dimension);
        values_[dimension] = value;
        read_[dimension / 64] |= std::uint64_t{1} << (dimension % 64);
    }
    /// No dimensions; the memory is kept.
    void clear() {
        values_.clear();
        read_.clear();
    }

    friend bool operator==(const StoredSample&, const StoredSample&) = default;

    /// Hands all that it holds to archive(...), to be written or to be filled
    /// (render/checkpoint.h).
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.values_, self.read_);
    }
    /// Is what an archive filled in a sample?
    bool is_sound() const { return read_.size() == (values_.size() + 63) / 64; }

private:
    /// Room for the dimension, and for the next ones, which paths read soon.
    [[gnu::noinline]] void grow(std::uint32_t dimension) {
        constexpr std::uint32_t kAtOnce = 16;  // divides 64
        values_.resize((dimension / kAtOnce + 1) * kAtOnce);
        read_.resize(dimension / 64 + 1);
    }

    std::vector<std::uint64_t> values_;
    std::vector<std::uint64_t> read_;  // one bit a dimension
};

/// Keeps what another reader gives.
template <PrimarySampleReader Source>
class RecordingReader {
public:
    /// @param to  where to; empty.
    RecordingReader(Source source, StoredSample& to) : source_(source), to_(to) {}

    std::uint64_t operator()(std::uint32_t dimension) {
        if (!to_.has(dimension)) to_.set(dimension, source_(dimension));
        return to_[dimension];
    }

private:
    Source source_;
    StoredSample& to_;
};

/// Reads a sample again. What it lacks is drawn; a path that was traced from it before lacks none.
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

/// Dimensions that the parent has read move; the others are drawn. What the parent has read and the
/// new path does not is forgotten.
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
