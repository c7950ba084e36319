// MatteId: what a Cryptomatte stores in place of a name.
//
// Source: Cryptomatte Specification 1.2.0, "ID Generation".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// The bits of a float that is neither 0, denormal, infinite nor NaN; 0 stands for no object.
using MatteId = std::uint32_t;

inline constexpr MatteId kNoMatteId = 0;

/// Returns the ID of a name: its hash, with the lowest bit of the exponent toggled where the hash
/// would be no normal float ("uint32_to_float32").
/// @param name  in UTF-8.
MatteId matte_id(std::string_view name);

/// Returns the ID as 8 hexadecimal digits, as a manifest has it.
std::string hex_of(MatteId id);

/// Returns the names' bytes as UTF-8: each byte that is none becomes U+FFFD.
std::string as_utf8(std::string_view name);

}  // namespace sunfleck::engine
