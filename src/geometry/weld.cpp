// Positions are the same if their bits are, after -0 has become 0.
#include "geometry/weld.h"

#include <bit>

namespace sunfleck::engine {
namespace {

/// Spreads the bits of a position over 64 bits (the finaliser of MurmurHash3, twice).
std::uint64_t spread(const Vec3& p) {
    const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x + 0.0F)}; };
    std::uint64_t h = bits(p.x) | bits(p.y) << 32U;
    h ^= h >> 33U;
    h *= 0xFF51AFD7ED558CCDULL;
    h ^= h >> 29U;
    h += bits(p.z) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 32U;
    h *= 0xC4CEB9FE1A85EC53ULL;
    return h ^ h >> 33U;
}

}  // namespace

std::size_t Welder::slot_of(const Vec3& position) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = spread(position) & mask;
    while (slots_[slot] != 0 && positions_[slots_[slot] - 1] != position) slot = (slot + 1) & mask;
    return slot;
}

void Welder::grow() {
    constexpr std::size_t kFirst = 1024;
    slots_.assign(slots_.empty() ? kFirst : 2 * slots_.size(), 0);
    for (std::size_t i = 0; i < positions_.size(); ++i)
        slots_[slot_of(positions_[i])] = static_cast<std::uint32_t>(i + 1);
}

std::uint32_t Welder::number_of(const Vec3& position) {
    if (3 * positions_.size() >= 2 * slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(position)];
    if (slot == 0) {
        positions_.push_back(position);
        slot = static_cast<std::uint32_t>(positions_.size());
    }
    return slot - 1;
}

}  // namespace sunfleck::engine
