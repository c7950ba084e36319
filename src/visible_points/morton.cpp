// Morton codes, and a radix sort by them.
#include "visible_points/morton.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sunfleck::engine {
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

namespace {

constexpr unsigned kDigit = 11;
constexpr unsigned kCodeBits = 63;
/// By digit: how many keys of a block have it, then where the first of these goes.
using Places = std::array<std::size_t, std::size_t{1} << kDigit>;

std::size_t digit(const MortonKey& key, unsigned shift) {
    return (key.code >> shift) & ((std::size_t{1} << kDigit) - 1);
}

/// Turns the counts of all blocks into places: digit by digit, within one block by block.
/// @return false when all keys have the same digit.
bool make_places(std::vector<Places>& blocks, std::size_t keys) {
    std::size_t next = 0;
    for (std::size_t d = 0; d < Places().size(); ++d) {
        const std::size_t first = next;
        for (Places& block : blocks) next += std::exchange(block[d], next);
        if (next - first == keys) return false;
    }
    return true;
}

}  // namespace

/// Least significant digit first; digits that are the same everywhere are skipped. Each block moves
/// its keys to where they belong: after those of the blocks before, whatever the blocks are.
void sort_by_code(MortonKeys& keys, unsigned bits) {
    constexpr std::size_t kLeastBlock = std::size_t{1} << 14U;
    const std::size_t block = block_of_a_thread(keys.size(), kLeastBlock);
    std::vector<Places> places((keys.size() + block - 1) / block);
    MortonKeys other(keys.size());
    for (unsigned shift = kCodeBits - bits; shift < kCodeBits; shift += kDigit) {
        parallel_blocks(keys.size(), block, [&](std::size_t begin, std::size_t end) {
            Places& counts = places[begin / block];
            counts.fill(0);
            for (std::size_t i = begin; i < end; ++i) ++counts[digit(keys[i], shift)];
        });
        if (!make_places(places, keys.size())) continue;
        parallel_blocks(keys.size(), block, [&](std::size_t begin, std::size_t end) {
            Places& next = places[begin / block];
            for (std::size_t i = begin; i < end; ++i)
                other[next[digit(keys[i], shift)]++] = keys[i];
        });
        keys.swap(other);
    }
}

}  // namespace sunfleck::engine
