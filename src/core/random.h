// Counter-based random streams: number n of a stream is a function of the stream's name alone.
//
// In:  a seed, and a name (purpose, pass, index) that is unique in the render.
// Out: 64-bit fractions of the unit interval, 32-bit words, or numbers of the open interval (0,1);
// the same on every machine.
// Source: Philox4x32-10; Salmon et al., Parallel Random Numbers: As Easy as 1, 2, 3 (SC 2011).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

using RandomBlock = std::array<std::uint32_t, 4>;

/// A keyed bijection on 128-bit counters: distinct counters give distinct, unrelated blocks.
constexpr RandomBlock philox(RandomBlock counter, std::uint64_t key) {
    auto key_low = static_cast<std::uint32_t>(key);
    auto key_high = static_cast<std::uint32_t>(key >> 32U);
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t even = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t odd = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {static_cast<std::uint32_t>(odd >> 32U) ^ counter[1] ^ key_low,
                   static_cast<std::uint32_t>(odd),
                   static_cast<std::uint32_t>(even >> 32U) ^ counter[3] ^ key_high,
                   static_cast<std::uint32_t>(even)};
        key_low += 0x9E3779B9;
        key_high += 0xBB67AE85;
    }
    return counter;
}

/// Purpose of a stream: one value per place that draws numbers, so that no two places share them.
enum class Purpose : std::uint32_t {
    wavelengths,
    camera,
    uniform_path,
    sobol_shift,
    chain,
    reference_path,
    test,
    splitting,
    light_path,
    pair_camera,
    pair_light,
    pair_joints,
    metropolis_bootstrap,
    metropolis_step,
    metropolis_choice,
    importon,
    edge_search,
    caster,
    edge_probe
};

/// Converts a 64-bit fraction to a double of the open interval (0,1): an odd multiple of 2^-53.
constexpr double to_unit(std::uint64_t fraction) {
    return (static_cast<double>(fraction >> 12U) + 0.5) * 0x1p-52;
}

/// Inverts to_unit(). @param unit  in [0,1].
constexpr std::uint64_t to_fraction(double unit) {
    return static_cast<std::uint64_t>((unit < 1 ? unit : 1 - 0x1p-53) * 0x1p64);
}

/// Converts the highest 32 bits of a fraction to a float of (0,1): an odd multiple of 2^-24.
constexpr float word_to_unit_float(std::uint32_t word) {
    return (static_cast<float>(word >> 9U) + 0.5F) * 0x1p-23F;
}

/// Converts a 64-bit fraction to a float of (0,1).
constexpr float to_unit_float(std::uint64_t fraction) {
    return word_to_unit_float(static_cast<std::uint32_t>(fraction >> 32U));
}

/// A random stream with random access: number i is available in any order.
class RandomStream {
public:
    /// @param substream  see PassId::substream.
    constexpr RandomStream(std::uint64_t seed, Purpose purpose, std::uint32_t pass,
                           std::uint32_t index, std::uint32_t substream = 0)
        : seed_(seed),
          name_{0, index, pass, static_cast<std::uint32_t>(purpose) | substream << 16U} {}

    /// Returns number i as a 64-bit fraction. Numbers i and i ^ 1 share one Philox block.
    constexpr std::uint64_t at(std::uint32_t i) {
        go_to(i >> 1U);
        const std::size_t half = (i & 1U) * 2;
        return (std::uint64_t{block_.at(half)} << 32U) | block_.at(half + 1);
    }

    /// Returns 32-bit word i; number i consists of words 2 i and 2 i + 1. Words i to i | 3 share
    /// one block.
    constexpr std::uint32_t word(std::uint32_t i) {
        go_to(i >> 2U);
        return block_.at(i & 3U);
    }

    /// Returns the word after the last one that any next_...() has read. A stream has 2^32 words.
    constexpr std::uint32_t next_word() { return word(next_++); }
    /// Returns the first number after that word.
    constexpr std::uint64_t next_fraction() {
        const std::uint32_t i = (next_ + 1) / 2;
        next_ = 2 * i + 2;
        return at(i);
    }
    constexpr double next() { return to_unit(next_fraction()); }
    constexpr float next_float() { return to_unit_float(next_fraction()); }

private:
    constexpr void go_to(std::uint32_t block) {
        if (block + 1 == cached_) return;
        cached_ = block + 1;
        name_[0] = block;
        block_ = philox(name_, seed_);
    }

    std::uint64_t seed_;
    RandomBlock name_;
    RandomBlock block_{};
    std::uint32_t cached_ = 0;
    std::uint32_t next_ = 0;  // index of the next word
};

/// Identifies a pass of a render; all randomness of the pass depends on it alone.
struct PassId {
    std::uint64_t seed = 0;
    std::uint32_t number = 0;     // from 0
    std::uint32_t substream = 0;  // of replicate() and with_stratum(); below 2^16

    /// Returns the stream of one pixel, uniform path or chain of this pass. @param index  below
    /// 2^32.
    constexpr RandomStream stream(Purpose purpose, std::size_t index) const {
        return {seed, purpose, number, static_cast<std::uint32_t>(index), substream};
    }
    /// Returns the id of other random numbers for the same pass. @param which  below 128.
    constexpr PassId replicate(std::uint32_t which) const {
        return {seed, number, which * kStrata};
    }
    /// Returns the id of one light stratum of the pass. @param which  below kStrata.
    constexpr PassId with_stratum(std::uint32_t which) const {
        return {seed, number, substream + which};
    }

    static constexpr std::uint32_t kStrata = 512;  // strata of a pass
};

}  // namespace sunfleck::engine
