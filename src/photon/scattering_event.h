// A photon on its way, and how it goes on from a surface.
//
// A turn is worked out first and taken then: whoever has several photons at surfaces works out all
// their turns, which do not wait for each other, before any of them is decided.
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

namespace sunfleck {

/// A photon on its way: what the next event needs to know.
struct PhotonState {
    Spectrum flux;
    Vec3 direction{0};
    LaneChoice lanes;
    bool lane_read = false;
    std::uint16_t bounces = 0;
    PhotonKind kind = PhotonKind::direct;
    std::uint8_t light_layer = kNoLightLayer;
    bool at_light = true;     // about to leave it
    MediumNumber medium = 0;  // of the next ray
    /// The flux over what roulette makes it: 1 but where a medium took some of it, or a shading
    /// normal at a rim made it more.
    float throughput = 1;
    Vec3d origin{0};  // of the next ray
    Vec3d first_direction{0};
    float unlit = 0;  // still to go where it lights nothing: Emission
};

/// What becomes of a photon that a surface scatters.
struct Turn {
    Spectrum flux;  // before roulette
    Vec3 direction{0};
    float throughput = 0;    // below 1: the probability with which the photon survives
    float number = 1;        // of roulette: it does if this is below
    bool is_rough = false;   // it was no delta lobe
    bool disperses = false;  // other lanes than the chosen one are zero
};

namespace turn_detail {

/// Where a surface sends a photon, as far as its bsdf and normals say.
struct Departure {
    Spectrum weight;  // of the flux
    Vec3 direction{0};
    bool is_rough = false;
    bool disperses = false;
};

/// A bsdf's own sample, corrected for the shading normal (Veach 1997, section 5.3.2).
inline std::optional<Departure> departure(const Bsdf& bsdf, const Hit& hit, const Vec3& came,
                                          const BsdfDraw& draw) {
    const Frame frame(hit.shading_normal, hit.tangent);
    const Vec3 w_from = frame.to_local(-came);
    const auto drawn = sample(bsdf, w_from, draw);
    if (!drawn) return {};
    const Vec3 w_to = frame.to_world(drawn->w_to);
    Spectrum weight = drawn->weight;
    if (hit.shading_normal != hit.normal)
        weight *= std::abs(w_from.z * w_to.dot(hit.normal)) /
                  std::abs(came.dot(hit.normal) * drawn->w_to.z);
    return Departure{weight, w_to, drawn->pdf.has_value(), drawn->dispersed};
}

/// A Lambertian surface sends flux as |n_g.w| on the side of its shading normal where it is lit:
/// drawn so, no direction weighs more than another. What a lobe around n_g has on the other side is
/// the point reflection of what it lacks on this one.
inline std::optional<Departure> departure(const Lambert& bsdf, const Hit& hit, const Vec3& came,
                                          const BsdfDraw& draw) {
    const Frame frame(hit.normal, hit.tangent);
    const float facing = -came.dot(hit.shading_normal);
    const auto drawn = bsdf.sample({0, 0, facing}, draw);
    const Vec3 w_to = frame.to_world(drawn->w_to);
    if (hit.shading_normal == hit.normal) return Departure{bsdf.albedo, w_to, true, false};
    return Departure{bsdf.albedo * std::abs(facing / came.dot(hit.normal)),
                     w_to.dot(hit.shading_normal) * facing < 0 ? -w_to : w_to, true, false};
}

/// The numbers of u that the surface makes a direction of; the others are left unread, as chains
/// have less to move then. @param unit  gives a slot's number.
template <class Unit>
Vec3 numbers_for(const Lambert&, const Unit& unit) {
    return {0, unit(BounceSlot::direction_u), unit(BounceSlot::direction_v)};
}
template <class Unit>
Vec3 numbers_for(const Bsdf& bsdf, const Unit& unit) {
    if (scattering(bsdf) == Scattering::specular) return {unit(BounceSlot::lobe), 0, 0};
    return {unit(BounceSlot::lobe), unit(BounceSlot::direction_u), unit(BounceSlot::direction_v)};
}

}  // namespace turn_detail

/// What a loss leaves of the flux. A light that is dark at the wavelengths of the pass sends paths
/// as if it were grey: what a pilot learns of them holds for other passes, too.
/// @param before  sum of the flux. @param after  the flux. @param loss  its factor.
inline float share_kept(float before, const Spectrum& after, const Spectrum& loss) {
    return before > 0 ? after.sum() / before : loss.sum() / static_cast<float>(kLanes);
}

/// One scattering event, but for what wavelengths have to do with it. @tparam Surface  a Bsdf, or
/// one that it may be.
template <SlotReader Reader, class Surface>
[[gnu::always_inline]] inline Turn draw_turn(Reader& read, const Surface& bsdf, const Hit& hit,
                                             const PhotonState& state) {
    const auto unit = [&](BounceSlot which) {
        return to_unit_float(read(slot(state.bounces, which)));
    };
    const BsdfDraw draw{turn_detail::numbers_for(bsdf, unit), Transport::flux, state.lanes};
    const auto left = turn_detail::departure(bsdf, hit, state.direction, draw);
    if (!left) return {};
    const Spectrum flux = state.flux * left->weight;
    const float kept = share_kept(state.flux.sum(), flux, left->weight);
    const float throughput = state.throughput * kept;
    const float number = throughput < 1 ? unit(BounceSlot::roulette) : 0;
    return {flux, left->direction, throughput, number, left->is_rough, left->disperses};
}

/// Of a photon that so many smooth surfaces have scattered, and no rough one.
inline PhotonKind kind_after_smooth(int events) {
    if (events == 0) return PhotonKind::direct;
    return events < kDeepCaustic ? PhotonKind::caustic : PhotonKind::deep_caustic;
}

/// Roulette, and the photon after it. One that grew fades first, surface by surface.
/// @return false when it is absorbed.
inline bool take_turn(const Turn& turn, PhotonState& state) {
    if (!(turn.number < turn.throughput)) return false;
    if (turn.disperses) state.lanes.single = true;
    if (turn.is_rough)
        state.kind = PhotonKind::indirect;
    else if (state.kind != PhotonKind::indirect)
        state.kind = kind_after_smooth(state.bounces + 1);
    state.flux = turn.flux / std::min(1.0F, turn.throughput);
    state.throughput = std::max(1.0F, turn.throughput);
    state.direction = turn.direction;
    ++state.bounces;
    return true;
}

}  // namespace sunfleck
