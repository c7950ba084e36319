// The hash MurmurHash3_x86_32, by which Cryptomatte makes IDs of names.
//
// Source: Austin Appleby, MurmurHash3 (2011, public domain): the constants and their order.
#pragma once

#include <cstdint>
#include <string_view>

namespace sunfleck::engine {

/// Returns the 32-bit hash of the bytes, the same on every machine.
std::uint32_t murmur3_32(std::string_view bytes, std::uint32_t seed = 0);

}  // namespace sunfleck::engine
