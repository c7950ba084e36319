// Numbers as binary files hold them, the lowest byte first.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace sunfleck::engine {

inline void append_word(std::string& bytes, std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(word >> shift)));
}

inline void append_float(std::string& bytes, float value) {
    append_word(bytes, std::bit_cast<std::uint32_t>(value));
}

}  // namespace sunfleck::engine
