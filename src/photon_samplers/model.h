// PhotonSamplerModel: the concept that photon samplers satisfy; there is no base class.
//
// A photon sampler chooses the photon paths of a pass. In: the visible points of the pass, and a
// plan: light strata with their numbers of photon paths. Out: the photons' contributions, added to
// an image, and statistics.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "estimate/photon_counts.h"
#include "photon/light_stratum.h"
#include "photon/settings.h"

#include <concepts>
#include <string_view>
#include <variant>
#include <vector>

namespace sunfleck::engine {

/// The photon paths of a pass.
struct PhotonPass {
    const PhotonContext& photon_context;
    PassId id;  // names their random numbers
    const std::vector<LightStratum>& strata;
    const PhotonSettings& settings;
};

/// Image to which the contributions of photons are added.
struct PhotonTarget {
    PassImage& image;
    PhotonCounts* taken = nullptr;  // counts of gathered photons by pixel; null: none are kept
};

/// Statistic of one sampler.
struct SamplerSum {
    std::string_view name;  // in film files and stats.json
    double value = 0;
};

/// Statistics of the photons of a pass.
struct PhotonTotals {
    Statistics statistics;
    double visible_fraction = 0;        // this pass's estimate, of uniform paths from all lights
    std::vector<StratumCounts> strata;  // in the order of PhotonPass::strata
    std::vector<SamplerSum> sums{};

    /// Adds the next stratum, but not its paths to the statistics: the caller has.
    void add_stratum(StratumCounts counts);
};

/// Bytes that a render holds while photons are traced, fitted to measured peaks.
struct SamplerMemory {
    /// Of a pixel: sums of film, pass and picture; a visible point and its place in the index.
    std::uint64_t pixel = 0;
    /// Of a photon path: itself and its photons, until they are deposited.
    std::uint64_t path = 0;
};

/// The state of a sampler whose passes are independent of each other.
using NoState = std::monostate;

/// What a sampler has:
/// kind:          its value of the enum PhotonSampler.
/// name:          its name in flags.
/// what:          its explanation in the help.
/// learns:        whether pilots and trials make the plan of an epoch (planning/learn_epoch.h). If
///                not, the plan is one stratum of all lights.
/// State:         what it carries from pass to pass; NoState where passes are independent.
/// memory:        bytes that it holds.
/// default_paths: photon paths per pass where the user gives no number.
/// settings_text: lines for RenderSettings::text() of the settings that it alone has.
/// trace:         adds the contributions of a pass's photons to the target.
template <class S>
concept PhotonSamplerModel = requires(const PhotonSettings& settings, std::size_t pixels,
                                      const PhotonPass& pass, const PhotonTarget& target,
                                      typename S::State& state) {
    { S::kind } -> std::convertible_to<PhotonSampler>;
    { S::name } -> std::convertible_to<std::string_view>;
    { S::what } -> std::convertible_to<std::string_view>;
    { S::learns } -> std::convertible_to<bool>;
    { S::memory } -> std::convertible_to<SamplerMemory>;
    { S::default_paths(pixels) } -> std::same_as<std::uint32_t>;
    { S::settings_text(settings) } -> std::same_as<std::string>;
    { S::trace(pass, target, state) } -> std::same_as<PhotonTotals>;
};

/// The concept that the state of a sampler satisfies, if there is one.
///
/// It is constructed from the settings, alpha of the radius sequence, and the number of pixels. Its
/// static visit(self, archive) passes all members to any archive, as StoredSample::visit() does.
/// is_sound: whether it can be the state after `passes` passes of a picture of `pixels` pixels.
/// shrink:   sets the gather radii of a pass's visible points. Returns their mean factor.
template <class T>
concept SamplerStateModel = std::copyable<T> &&
    std::constructible_from<T, const PhotonSettings&, double, std::size_t> &&
    requires(const T& state, VisiblePointLists& points, std::size_t pixels, std::uint64_t passes) {
    { state.is_sound(pixels, passes) } -> std::same_as<bool>;
    { state.shrink(points) } -> std::same_as<double>;
};

}  // namespace sunfleck::engine
