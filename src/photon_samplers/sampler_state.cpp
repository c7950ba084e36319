// Each question goes to the state that there is.
#include "photon_samplers/sampler_state.h"

#include <type_traits>

namespace sunfleck::engine {

std::optional<double> shrink_radii(const SamplerState& state, VisiblePointLists& points) {
    return std::visit(
        [&]<class State>(const State& s) -> std::optional<double> {
            if constexpr (std::is_same_v<State, NoState>)
                return {};
            else
                return s.shrink(points);
        },
        state);
}

bool is_sound(const SamplerState& state, std::size_t pixels, std::uint64_t passes) {
    return std::visit(
        [&]<class State>(const State& s) {
            if constexpr (std::is_same_v<State, NoState>)
                return true;
            else
                return s.is_sound(pixels, passes);
        },
        state);
}

}  // namespace sunfleck::engine
