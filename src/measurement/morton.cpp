// Morton codes, and a radix sort by them.
#include "measurement/morton.h"

#include <algorithm>
#include <array>

namespace sunfleck {
namespace {

constexpr float kCells = 0x1FFFFF;

/// Spreads the low 21 bits of x so that two zeros stand between neighbours.
std::uint64_t spread_bits(std::uint64_t x) {
    x &= 0x1FFFFFU;
    x = (x | (x << 32U)) & 0x1F00000000FFFFU;
    x = (x | (x << 16U)) & 0x1F0000FF0000FFU;
    x = (x | (x << 8U)) & 0x100F00F00F00F00FU;
    x = (x | (x << 4U)) & 0x10C30C30C30C30C3U;
    return (x | (x << 2U)) & 0x1249249249249249U;
}

}  // namespace

MortonGrid::MortonGrid(const Vec3& low, const Vec3& high) : low_(low) {
    const Vec3 size = high - low;
    cells_per_unit_ = kCells / std::max({size.x, size.y, size.z, 1e-30F});
}

std::uint64_t MortonGrid::code(const Vec3& p) const {
    const auto axis = [&](int c) {
        const float cell = std::clamp((p[c] - low_[c]) * cells_per_unit_, 0.0F, kCells);
        return spread_bits(static_cast<std::uint64_t>(cell));
    };
    return axis(0) | (axis(1) << 1U) | (axis(2) << 2U);
}

/// Least significant digit first; digits that are the same everywhere are skipped.
void sort_by_code(std::vector<MortonKey>& keys, unsigned bits) {
    constexpr unsigned kDigit = 11;
    constexpr unsigned kBits = 63;
    std::vector<MortonKey> other(keys.size());
    for (unsigned shift = kBits - bits; shift < kBits; shift += kDigit) {
        const auto digit = [&](const MortonKey& k) {
            return (k.code >> shift) & ((1U << kDigit) - 1);
        };
        std::array<std::size_t, (1U << kDigit) + 1> start{};
        for (const MortonKey& k : keys) ++start[digit(k) + 1];
        if (std::find(start.begin(), start.end(), keys.size()) != start.end()) continue;
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        for (const MortonKey& k : keys) other[start[digit(k)]++] = k;
        keys.swap(other);
    }
}

}  // namespace sunfleck
