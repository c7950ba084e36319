// The slots of a photon path: which coordinate of u in [0,1)^D means what.
//
// Fixed layout: the emission's slots, then the same four for every scattering event, so that a
// small change of u is a small change of the path. A slot is a 64-bit fraction of one turn, whose
// wrap-around is exact; it is read once or not at all, and an unread slot is never drawn.
#pragma once

#include "core/random.h"

#include <concepts>

namespace sunfleck {

enum class EmissionSlot : std::uint32_t {
    position_u,
    position_v,
    direction_u,
    direction_v,
    light,
    lane,  // which wavelength lane a dispersive refraction keeps
    count
};
enum class BounceSlot : std::uint32_t { lobe, direction_u, direction_v, roulette, count };

constexpr std::uint32_t slot(EmissionSlot which) {
    return static_cast<std::uint32_t>(which);
}

/// @param bounce  0 at the first surface that scatters the photon.
constexpr std::uint32_t slot(std::uint32_t bounce, BounceSlot which) {
    return slot(EmissionSlot::count) + bounce * static_cast<std::uint32_t>(BounceSlot::count) +
           static_cast<std::uint32_t>(which);
}

/// Does the slot belong to how the photon leaves its light?
constexpr bool is_emission(std::uint32_t index) {
    return index < slot(EmissionSlot::count);
}

/// Slot i of a path's own stream. Of bounce slots no more than the highest 23 bits are read, so
/// each has one word, and all of a bounce share one random block; emission slots have 64 bits.
constexpr std::uint64_t slot_of(RandomStream& stream, std::uint32_t index) {
    if (is_emission(index)) return stream.at(index);
    constexpr std::uint32_t kEmissionSlots = slot(EmissionSlot::count);
    static_assert(2 * kEmissionSlots % 4 == 0);
    return std::uint64_t{stream.word(index + kEmissionSlots)} << 32U;
}

/// What a tracer sees of a primary sample: it names a slot and gets its fraction, the same each
/// time. The samplers differ in nothing but their readers.
template <class R>
concept SlotReader = requires(R& read, std::uint32_t index) {
    { read(index) } -> std::same_as<std::uint64_t>;
};

/// Independent uniform slots, of the path's own stream.
class IndependentReader {
public:
    explicit IndependentReader(RandomStream stream) : stream_(stream) {}
    std::uint64_t operator()(std::uint32_t index) { return slot_of(stream_, index); }

private:
    RandomStream stream_;
};

static_assert(SlotReader<IndependentReader>);

/// The primary samples of a pass's paths, all independent: the paper's uniform sampling.
class IndependentPoints {
public:
    explicit IndependentPoints(PassId pass) : pass_(pass) {}
    IndependentReader path(std::uint32_t number) const {
        return IndependentReader(pass_.stream(Purpose::uniform_path, number));
    }

private:
    PassId pass_;
};

}  // namespace sunfleck
