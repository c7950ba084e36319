// A photon on its way, and how it goes on from a surface.
//
// A scattering event is worked out first and taken then: whoever has several photons at surfaces
// works out all their events, which do not wait for each other, before any of them is decided.
// Source: as photon/tracer.h.
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

/// A photon on its way: what the next event needs to know.
struct PhotonState {
    SampledSpectrum flux;
    Vec3 direction{0};
    HeroWavelength hero;
    bool hero_read = false;
    std::uint16_t bounces = 0;
    PhotonKind kind = PhotonKind::direct;
    std::uint8_t light_group = kNoLightGroup;
    bool at_light = true;     // about to leave it
    MediumNumber medium = 0;  // of the next ray
    /// The flux over what Russian roulette makes it: 1 but where a medium took some of it, or a
    /// shading normal at a rim made it more.
    float throughput = 1;
    Vec3d origin{0};  // of the next ray
    Vec3d first_direction{0};
    float unlit = 0;  // still to go where it lights nothing: Emission
};

/// What becomes of a photon that a surface scatters.
struct ScatteringEvent {
    SampledSpectrum flux;  // before Russian roulette
    Vec3 direction{0};
    float throughput = 0;    // below 1: the probability with which the photon survives
    float number = 1;        // of Russian roulette: it does if this is below
    bool is_rough = false;   // it was no delta lobe
    bool disperses = false;  // other wavelengths than the chosen one are zero
};

namespace scattering_detail {

/// Where a surface sends a photon, as far as its bsdf and normals say.
struct CorrectedSample {
    SampledSpectrum weight;  // of the flux
    Vec3 direction{0};
    bool is_rough = false;
    bool disperses = false;
};

/// A bsdf's own sample, corrected for the shading normal (Veach 1997, section 5.3.2).
inline std::optional<CorrectedSample> corrected_sample(const Bsdf& bsdf, const Hit& hit,
                                                       const Vec3& came, const BsdfDraw& draw) {
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

/// A Lambertian surface sends flux as |n_g.w| on the side of its shading normal where it is lit:
/// drawn so, no direction weighs more than another. What a lobe around n_g has on the other side is
/// the point reflection of what it lacks on this one.
inline std::optional<CorrectedSample> corrected_sample(const Lambert& bsdf, const Hit& hit,
                                                       const Vec3& came, const BsdfDraw& draw) {
    const Frame frame(hit.normal, hit.tangent);
    const float facing = -came.dot(hit.shading_normal);
    const auto drawn = bsdf.sample({0, 0, facing}, draw);
    const Vec3 wi = frame.to_world(drawn->wi);
    if (hit.shading_normal == hit.normal) return CorrectedSample{bsdf.albedo, wi, true, false};
    return CorrectedSample{bsdf.albedo * std::abs(facing / came.dot(hit.normal)),
                           wi.dot(hit.shading_normal) * facing < 0 ? -wi : wi, true, false};
}

/// The numbers of u that the surface makes a direction of; the others are left unread, as chains
/// have less to move then. @param unit  gives a dimension's number.
template <class Unit>
Vec3 numbers_for(const Lambert&, const Unit& unit) {
    return {0, unit(BounceDimension::direction_u), unit(BounceDimension::direction_v)};
}
template <class Unit>
Vec3 numbers_for(const Bsdf& bsdf, const Unit& unit) {
    if (scattering(bsdf) == Scattering::specular) return {unit(BounceDimension::lobe), 0, 0};
    return {unit(BounceDimension::lobe), unit(BounceDimension::direction_u),
            unit(BounceDimension::direction_v)};
}

}  // namespace scattering_detail

/// What a loss leaves of the flux. A light that is dark at the wavelengths of the pass sends paths
/// as if it were grey: what a pilot learns of them holds for other passes, too.
/// @param before  sum of the flux. @param after  the flux. @param loss  its factor.
inline float share_kept(float before, const SampledSpectrum& after, const SampledSpectrum& loss) {
    return before > 0 ? after.sum() / before : loss.sum() / static_cast<float>(kWavelengths);
}

/// One scattering event, but for what wavelengths have to do with it. @tparam Surface  a Bsdf, or
/// one that it may be.
template <PrimarySampleReader Reader, class Surface>
[[gnu::always_inline]] inline ScatteringEvent sample_scattering(Reader& read, const Surface& bsdf,
                                                                const Hit& hit,
                                                                const PhotonState& state) {
    const auto unit = [&](BounceDimension which) {
        return to_unit_float(read(dimension(state.bounces, which)));
    };
    const BsdfDraw draw{scattering_detail::numbers_for(bsdf, unit), Transport::flux, state.hero};
    const auto left = scattering_detail::corrected_sample(bsdf, hit, state.direction, draw);
    if (!left) return {};
    const SampledSpectrum flux = state.flux * left->weight;
    const float kept = share_kept(state.flux.sum(), flux, left->weight);
    const float throughput = state.throughput * kept;
    const float number = throughput < 1 ? unit(BounceDimension::roulette) : 0;
    return {flux, left->direction, throughput, number, left->is_rough, left->disperses};
}

/// Of a photon that so many smooth surfaces have scattered, and no rough one.
inline PhotonKind kind_after_smooth(int events) {
    if (events == 0) return PhotonKind::direct;
    return events < kLongSpecularChain ? PhotonKind::caustic : PhotonKind::long_specular_chain;
}

/// Russian roulette, and the photon after it. One that grew fades first, surface by surface.
/// @return false when it is absorbed.
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
    ++state.bounces;
    return true;
}

}  // namespace sunfleck::engine
