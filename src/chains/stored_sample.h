// A primary sample whose slots exist once they were read, and the readers that fill it.
//
// In:  the numbers that a path asks for. Out: the same numbers again, and copies of the sample
// in which the slots that were read have moved a little. A slot that no path has read is never
// drawn: whether a path is visible does not depend on it (docs/method.md).
#pragma once

#include "chains/mutation.h"
#include "random_numbers/primary_sample.h"

#include <vector>

namespace sunfleck {

class StoredSample {
public:
    bool has(std::uint32_t slot) const {
        return slot < values_.size() && ((read_[slot / 64] >> (slot % 64)) & 1U) != 0;
    }
    /// @param slot  one that it has.
    std::uint64_t operator[](std::uint32_t slot) const { return values_[slot]; }

    void set(std::uint32_t slot, std::uint64_t value) {
        if (slot >= values_.size()) grow(slot);
        values_[slot] = value;
        read_[slot / 64] |= std::uint64_t{1} << (slot % 64);
    }
    /// No slots; the memory is kept.
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
    /// Room for the slot, and for the next ones, which paths read soon.
    [[gnu::noinline]] void grow(std::uint32_t slot) {
        constexpr std::uint32_t kAtOnce = 16;  // divides 64
        values_.resize((slot / kAtOnce + 1) * kAtOnce);
        read_.resize(slot / 64 + 1);
    }

    std::vector<std::uint64_t> values_;
    std::vector<std::uint64_t> read_;  // one bit a slot
};

/// Keeps what another reader gives.
template <SlotReader Source>
class RecordingReader {
public:
    /// @param to  where to; empty.
    RecordingReader(Source source, StoredSample& to) : source_(source), to_(to) {}

    std::uint64_t operator()(std::uint32_t slot) {
        if (!to_.has(slot)) to_.set(slot, source_(slot));
        return to_[slot];
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

    std::uint64_t operator()(std::uint32_t slot) {
        if (!sample_.has(slot)) sample_.set(slot, stream_.next_fraction());
        return sample_[slot];
    }

private:
    StoredSample& sample_;
    RandomStream& stream_;
};

/// Slots that the parent has read move; the others are drawn. What the parent has read and the
/// new path does not is forgotten.
/// @tparam Move  move(slot number, value) -> new value, symmetric.
template <class Move>
class MutatingReader {
public:
    /// @param to  the new sample; empty.
    MutatingReader(const StoredSample& parent, StoredSample& to, RandomStream& stream, Move move)
        : parent_(parent), to_(to), stream_(stream), move_(move) {}

    std::uint64_t operator()(std::uint32_t slot) {
        if (!to_.has(slot))
            to_.set(slot, parent_.has(slot) ? move_(slot, parent_[slot]) : stream_.next_fraction());
        return to_[slot];
    }

private:
    const StoredSample& parent_;
    StoredSample& to_;
    RandomStream& stream_;
    Move move_;
};

}  // namespace sunfleck
