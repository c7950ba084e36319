// A checksum of 64-bit words: any change of one word changes it, as does any likely other damage.
//
// Each step is a bijection of the state for a given word, and of the word for a given state; the
// rotation brings high bits back down, so that no two single-bit faults cancel by themselves.
#pragma once

#include <bit>
#include <cstdint>

namespace sunfleck::engine {

class WordHash {
public:
    constexpr void add(std::uint64_t word) {
        state_ = std::rotl((state_ ^ word) * std::uint64_t{0x9E3779B97F4A7C15}, 29);
    }
    constexpr std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xCBF29CE484222325;
};

}  // namespace sunfleck::engine
