// Every photon sampler there is. To add one: write its files, then name it here and in
// PhotonSampler (photon/settings.h): docs/develop/adding.md.
#pragma once

#include "photon_samplers/paper_sampler.h"
#include "photon_samplers/sampler_state.h"
#include "photon_samplers/splitting_sampler.h"
#include "photon_samplers/uniform_sampler.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>

namespace sunfleck::engine {

template <PhotonSamplerModel... Samplers>
using PhotonSamplerVariant = std::variant<Samplers...>;

/// In the order of the help.
using AnyPhotonSampler =
    PhotonSamplerVariant<SplittingSampler, UniformSampler, RandomSampler, PaperSampler>;

struct PhotonSamplerRow {
    PhotonSampler sampler;
    std::string_view name;  // as the user writes it
    std::string_view what;
};

template <class... Samplers>
constexpr std::array<PhotonSamplerRow, sizeof...(Samplers)> rows_of(
    const std::variant<Samplers...>&) {
    return {{{Samplers::kind, Samplers::name, Samplers::what}...}};
}

inline constexpr auto kPhotonSamplers = rows_of(AnyPhotonSampler());

/// Whether each value of PhotonSampler has one row.
constexpr bool all_have_rows() {
    std::array<int, static_cast<std::size_t>(PhotonSampler::count)> rows{};
    for (const PhotonSamplerRow& row : kPhotonSamplers)
        ++rows.at(static_cast<std::size_t>(row.sampler));
    return std::all_of(rows.begin(), rows.end(), [](int count) { return count == 1; });
}
static_assert(all_have_rows());

std::string_view name_of(PhotonSampler sampler);

/// Returns whether pilots and trials make its plans.
bool learns(PhotonSampler sampler);

/// Returns whether each pass builds on those before.
bool has_state(PhotonSampler sampler);

SamplerMemory memory_of(PhotonSampler sampler);

/// Lines for RenderSettings::text().
std::string sampler_settings_text(const PhotonSettings& settings);

/// Returns the photon paths of a pass, unless learning finds another number better.
std::uint32_t usual_paths(const PhotonSettings& settings, std::size_t pixels);

/// The state before the first pass. @param alpha  of local radii. @param pixels  of the picture.
SamplerState first_state(const PhotonSettings& settings, double alpha, std::size_t pixels);

/// Adds the light of the photons of a pass to the image.
/// @param state  of the same sampler.
PhotonTotals trace_photons(const PhotonPass& pass, const PhotonTarget& target, SamplerState& state);

}  // namespace sunfleck::engine
