// Each question goes to the sampler that is asked for.
#include "photon_samplers/samplers.h"

namespace sunfleck::engine {
namespace {

template <class... Samplers>
AnyPhotonSampler find(PhotonSampler kind, const std::variant<Samplers...>& first) {
    AnyPhotonSampler found = first;
    ((Samplers::kind == kind ? void(found = Samplers()) : void()), ...);
    return found;
}

/// Calls `ask` with the sampler as a value of its own type.
template <class Ask>
auto visit_sampler(PhotonSampler kind, const Ask& ask) {
    return std::visit(ask, find(kind, AnyPhotonSampler()));
}

}  // namespace

std::string_view name_of(PhotonSampler sampler) {
    return visit_sampler(sampler, []<class S>(const S&) { return std::string_view(S::name); });
}

bool learns(PhotonSampler sampler) {
    return visit_sampler(sampler, []<class S>(const S&) { return S::learns; });
}

bool has_state(PhotonSampler sampler) {
    return visit_sampler(
        sampler, []<class S>(const S&) { return !std::is_same_v<typename S::State, NoState>; });
}

SamplerMemory memory_of(PhotonSampler sampler) {
    return visit_sampler(sampler, []<class S>(const S&) { return S::memory; });
}

std::string sampler_settings_text(const PhotonSettings& settings) {
    return visit_sampler(settings.sampler,
                         [&]<class S>(const S&) { return S::settings_text(settings); });
}

std::uint32_t usual_paths(const PhotonSettings& settings, std::size_t pixels) {
    return settings.paths_per_pass.value_or(visit_sampler(
        settings.sampler, [&]<class S>(const S&) { return S::default_paths(pixels); }));
}

SamplerState first_state(const PhotonSettings& settings, double alpha, std::size_t pixels) {
    return visit_sampler(settings.sampler, [&]<class S>(const S&) -> SamplerState {
        using State = typename S::State;
        if constexpr (std::is_same_v<State, NoState>)
            return NoState();
        else
            return State(settings, alpha, pixels);
    });
}

PhotonTotals trace_photons(const PhotonPass& pass, const PhotonTarget& target,
                           SamplerState& state) {
    return visit_sampler(pass.settings.sampler, [&]<class S>(const S&) {
        return S::trace(pass, target, std::get<typename S::State>(state));
    });
}

}  // namespace sunfleck::engine
