// Hashes of values, for choices that must be the same wherever and whenever they are made.
#pragma once

#include <cstdint>

namespace sunfleck::engine {

/// A bijection of 64 bits after which all of them depend on all.
/// Source: Stafford, Better Bit Mixing (2011), variant 13, as used by SplitMix64.
constexpr std::uint64_t hash_mixed(std::uint64_t bits) {
    bits = (bits ^ bits >> 30U) * 0xBF58476D1CE4E5B9;
    bits = (bits ^ bits >> 27U) * 0x94D049BB133111EB;
    return bits ^ bits >> 31U;
}

/// A hash of what `hash` is of, and of `bits` after it.
constexpr std::uint64_t hash_joined(std::uint64_t hash, std::uint64_t bits) {
    return hash_mixed(hash + 0x9E3779B97F4A7C15 + bits);
}

/// A hash as a number in [0,1).
constexpr float hash_to_unit(std::uint64_t hash) {
    return static_cast<float>(hash >> 40U) * 0x1p-24F;
}

}  // namespace sunfleck::engine
