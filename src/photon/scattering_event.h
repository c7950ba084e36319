// Scattering events of photons: sampling of the bsdf, shading-normal correction, Russian roulette.
//
// An event is first computed and then applied. A caller with several photons computes all their
// events, which do not depend on each other, before it applies any.
// Source: see photon/tracer.h.
// Equations: docs/method/method.md, eq. (9).
#pragma once

#include "bsdf/bsdf.h"
#include "geometry/ray.h"
#include "random_numbers/primary_sample.h"
#include "scene/media.h"
#include "visible_points/visible_point.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunfleck::engine {

/// A photon path in progress: the data that the next event needs.
struct PhotonState {
    SampledSpectrum flux;
    Vec3 direction{0};
    HeroWavelength hero;
    bool hero_read = false;
    std::uint16_t bounces = 0;
    PhotonKind kind = PhotonKind::direct;
    std::uint8_t light_group = kNoLightGroup;
    bool at_light = true;     // it has not left the light yet
    MediumNumber medium = 0;  // of the next ray
    /// Number of scattering events and of flights through media that scatter: each has dimensions
    /// of its own.
    std::uint32_t dimensions = 0;
    /// Flux over the flux that Russian roulette keeps constant: 1 unless a medium absorbed some of
    /// it, or the shading-normal correction increased it.
    float throughput = 1;
    Vec3d origin{0};  // of the next ray
    Vec3d first_direction{0};
    float unlit = 0;           // remaining distance without light: Emission::unlit
    float lit_to = kInfinity;  // remaining distance with light, until it is scattered
};

/// The result of a scattering event.
struct ScatteringEvent {
    SampledSpectrum flux;  // before Russian roulette
    Vec3 direction{0};
    float throughput = 0;  // survival probability, if below 1
    float number = 1;  // random number of Russian roulette: the photon survives if it is smaller
    bool is_rough = false;   // not a delta lobe
    bool disperses = false;  // wavelengths other than the hero are zero
};

namespace scattering_detail {

/// The sampled direction and weight at a surface, by its bsdf and normals.
struct CorrectedSample {
    SampledSpectrum weight;  // factor of the flux
    Vec3 direction{0};
    bool is_rough = false;
    bool disperses = false;
};

/// Samples the bsdf and applies the shading-normal correction (Veach 1997, section 5.3.2).
inline std::optional<CorrectedSample> corrected_sample(const Bsdf& bsdf, const Hit& hit,
                                                       const Vec3& came,
                                                       const BsdfSampleInput& draw) {
    const Frame frame(hit.shading_normal, hit.tangent);
    const Vec3 wo = frame.to_local(-came);
    const auto drawn = sample(bsdf, wo, draw);
    if (!drawn) return {};
    const Vec3 wi = frame.to_world(drawn->wi);
    SampledSpectrum weight = drawn->weight;
    if (hit.shading_normal != hit.normal)
        weight *=
            std::abs(wo.z * wi.dot(hit.normal)) / std::abs(came.dot(hit.normal) * drawn->wi.z);
    return CorrectedSample{weight, wi, drawn->pdf.has_value(), drawn->dispersed};
}

/// Samples a Lambertian surface by |n_g.w| on the side of its shading normal that is lit, so that
/// all directions have equal weight. The part of a lobe around n_g on the other side is replaced by
/// the point reflection of the missing part on this side.
inline std::optional<CorrectedSample> corrected_sample(const Lambert& bsdf, const Hit& hit,
                                                       const Vec3& came,
                                                       const BsdfSampleInput& draw) {
    const Frame frame(hit.normal, hit.tangent);
    const float facing = -came.dot(hit.shading_normal);
    const auto drawn = bsdf.sample({0, 0, facing}, draw);
    const Vec3 wi = frame.to_world(drawn->wi);
    if (hit.shading_normal == hit.normal) return CorrectedSample{bsdf.albedo, wi, true, false};
    return CorrectedSample{bsdf.albedo * std::abs(facing / came.dot(hit.normal)),
                           wi.dot(hit.shading_normal) * facing < 0 ? -wi : wi, true, false};
}

/// Returns the random numbers that the surface uses for a direction; others stay unread, so that
/// chains have fewer dimensions to move. @param unit  returns the number of a dimension.
template <class Unit>
Vec3 numbers_for(const Lambert&, const Unit& unit) {
    return {0, unit(BounceDimension::direction_u), unit(BounceDimension::direction_v)};
}
template <class Unit>
Vec3 numbers_for(const HenyeyGreenstein&, const Unit& unit) {
    return {0, unit(BounceDimension::direction_u), unit(BounceDimension::direction_v)};
}
template <class Unit>
Vec3 numbers_for(const Bsdf& bsdf, const Unit& unit) {
    if (scattering(bsdf) == Scattering::specular) return {unit(BounceDimension::lobe), 0, 0};
    return {unit(BounceDimension::lobe), unit(BounceDimension::direction_u),
            unit(BounceDimension::direction_v)};
}

}  // namespace scattering_detail

/// Returns the fraction of the flux that a loss keeps. A light that is dark at the wavelengths of
/// the pass counts as grey, so that what a pilot learns holds for other passes, too.
/// @param before  sum of the flux before.
/// @param after  the flux after.
/// @param loss  factor of the loss.
[[gnu::always_inline]] inline float share_kept(float before, const SampledSpectrum& after,
                                               const SampledSpectrum& loss) {
    return before > 0 ? after.sum() / before : loss.sum() / static_cast<float>(kWavelengths);
}

/// Computes one scattering event, except for its effect on wavelengths. @tparam Surface  a Bsdf, or
/// one of its alternatives.
template <PrimarySampleReader Reader, class Surface>
[[gnu::always_inline]] inline ScatteringEvent sample_scattering(Reader& read, const Surface& bsdf,
                                                                const Hit& hit,
                                                                const PhotonState& state) {
    const auto unit = [&](BounceDimension which) {
        return to_unit_float(read(dimension(state.dimensions, which)));
    };
    const BsdfSampleInput draw{scattering_detail::numbers_for(bsdf, unit), Transport::flux,
                               state.hero};
    const auto left = scattering_detail::corrected_sample(bsdf, hit, state.direction, draw);
    if (!left) return {};
    const SampledSpectrum flux = state.flux * left->weight;
    const float kept = share_kept(state.flux.sum(), flux, left->weight);
    const float throughput = state.throughput * kept;
    const float number = throughput < 1 ? unit(BounceDimension::roulette) : 0;
    return {flux, left->direction, throughput, number, left->is_rough, left->disperses};
}

/// Returns the kind of a photon that only specular surfaces, `events` of them, have scattered.
inline PhotonKind kind_after_smooth(int events) {
    if (events == 0) return PhotonKind::direct;
    return events < kLongSpecularChain ? PhotonKind::caustic : PhotonKind::long_specular_chain;
}

/// Applies Russian roulette to the photon. A throughput above one decreases first, surface by
/// surface. @return false if the photon is absorbed.
inline bool apply_event(const ScatteringEvent& event, PhotonState& state) {
    if (!(event.number < event.throughput)) return false;
    if (event.disperses) state.hero.single = true;
    if (event.is_rough)
        state.kind = PhotonKind::indirect;
    else if (state.kind != PhotonKind::indirect)
        state.kind = kind_after_smooth(state.bounces + 1);
    state.flux = event.flux / std::min(1.0F, event.throughput);
    state.throughput = std::max(1.0F, event.throughput);
    state.direction = event.direction;
    state.lit_to = kInfinity;
    ++state.bounces;
    ++state.dimensions;
    return true;
}

}  // namespace sunfleck::engine
