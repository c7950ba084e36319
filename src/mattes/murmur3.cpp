// Words of four bytes, least significant first, then what is left, then the length.
#include "mattes/murmur3.h"

#include <bit>
#include <cstddef>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kWord = 4;  // bytes

/// Returns up to four bytes as a word.
std::uint32_t word_of(std::string_view bytes) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        word |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return word;
}

std::uint32_t spread(std::uint32_t word) {
    return std::rotl(word * 0xCC9E2D51U, 15) * 0x1B873593U;
}

std::uint32_t finished(std::uint32_t hash) {
    hash = (hash ^ hash >> 16U) * 0x85EBCA6BU;
    hash = (hash ^ hash >> 13U) * 0xC2B2AE35U;
    return hash ^ hash >> 16U;
}

}  // namespace

std::uint32_t murmur3_32(std::string_view bytes, std::uint32_t seed) {
    std::uint32_t hash = seed;
    std::string_view rest = bytes;
    for (; rest.size() >= kWord; rest.remove_prefix(kWord))
        hash = std::rotl(hash ^ spread(word_of(rest.substr(0, kWord))), 13) * 5 + 0xE6546B64U;
    hash ^= spread(word_of(rest));
    return finished(hash ^ static_cast<std::uint32_t>(bytes.size()));
}

}  // namespace sunfleck::engine
