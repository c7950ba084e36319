// The first five dimensions of Sobol's sequence, by byte tables: four look-ups a number.
//
// Source: direction numbers of Joe and Kuo, Constructing Sobol sequences with better
// two-dimensional projections (SIAM J. Sci. Comput. 2008), file new-joe-kuo-6.21201.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunfleck::engine {

inline constexpr std::size_t kSobolDimensions = 5;

namespace sobol_detail {

using Directions = std::array<std::uint32_t, 32>;

/// @param degree, coefficients  of the primitive polynomial; @param first  its m_1 .. m_degree.
constexpr Directions directions(std::size_t degree, std::uint32_t coefficients,
                                std::array<std::uint32_t, 3> first) {
    Directions v{};
    for (std::size_t i = 0; i < 32; ++i) {
        if (degree == 0) {  // van der Corput
            v.at(i) = 1U << (31 - i);
        } else if (i < degree) {
            v.at(i) = first.at(i) << (31 - i);
        } else {
            v.at(i) = v.at(i - degree) ^ (v.at(i - degree) >> degree);
            for (std::size_t k = 1; k < degree; ++k)
                if (((coefficients >> (degree - 1 - k)) & 1U) != 0) v.at(i) ^= v.at(i - k);
        }
    }
    return v;
}

using ByteTables = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr ByteTables byte_tables(const Directions& v) {
    ByteTables tables{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::size_t value = 0; value < 256; ++value)
            for (std::size_t bit = 0; bit < 8; ++bit)
                if (((value >> bit) & 1U) != 0) tables.at(byte).at(value) ^= v.at(byte * 8 + bit);
    return tables;
}

inline constexpr std::array<ByteTables, kSobolDimensions> kTables = {
    byte_tables(directions(0, 0, {})), byte_tables(directions(1, 0, {1})),
    byte_tables(directions(2, 1, {1, 3})), byte_tables(directions(3, 1, {1, 3, 1})),
    byte_tables(directions(3, 2, {1, 1, 1}))};

}  // namespace sobol_detail

/// Coordinate `dimension` of point `index` as a fraction of 2^32; not scrambled.
constexpr std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    const auto& table = sobol_detail::kTables[dimension];
    return table[0][index & 255U] ^ table[1][(index >> 8U) & 255U] ^
           table[2][(index >> 16U) & 255U] ^ table[3][index >> 24U];
}

}  // namespace sunfleck::engine
