// What the photon sampler of a render carries from pass to pass, as a closed variant.
#pragma once

#include "photon_samplers/model.h"
#include "photon_samplers/paper_memory.h"

#include <cstdint>
#include <optional>
#include <variant>

namespace sunfleck::engine {

template <SamplerStateModel... States>
using SamplerStateVariant = std::variant<NoState, States...>;

/// What the sampler of a render carries from pass to pass. Checkpoints hold the index of the
/// alternative: new ones stand at the end.
using SamplerState = SamplerStateVariant<PaperMemory>;

/// Sets the gather radii of a pass's visible points.
/// @return their mean factor, or nothing if the state has no say in them.
std::optional<double> shrink_radii(const SamplerState& state, VisiblePointLists& points);

/// Can it be the state after so many passes of a picture of so many pixels?
bool is_sound(const SamplerState& state, std::size_t pixels, std::uint64_t passes);

}  // namespace sunfleck::engine
