// What a BSDF must offer, as a concept: no base class, no virtual call, no registration.
//
// Frame: the local shading frame, normal +z. w_from and w_to are unit vectors that both point away
// from the surface: w_from back to where the path came from, w_to on to where it goes.
#pragma once

#include "math/sampled_spectrum.h"
#include "math/vector.h"

#include <concepts>
#include <optional>

namespace sunfleck {

/// What the path being sampled carries: radiance from the eye, flux from a light. The two differ
/// by the squared ratio of refractive indices at a refraction (Veach 1997, section 5.2).
enum class Transport { radiance, flux };

struct BsdfSample {
    Spectrum weight;  // f |cos theta_to| / pdf; unitless
    Vec3 w_to;
    std::optional<float> pdf;  // per steradian; none for a delta lobe, whose weight says it all
    float eta = 1;             // index of the side of w_to over that of w_from; 1 for reflection
    bool dispersed = false;    // only LaneChoice::chosen is left in weight (already times kLanes)
};

/// The numbers that one scattering event may use: u in (0,1)^3 (lobe, direction, direction).
struct BsdfDraw {
    Vec3 u;
    Transport transport = Transport::radiance;
    LaneChoice lanes;
};

/// How a path treats the surface.
enum class Scattering {
    specular,  // only delta lobes: always continue
    glossy,    // narrow, perhaps beside a delta lobe: gather or continue (docs/method.md, owners)
    diffuse,   // wide: gather
    coated     // diffuse under a specular or glossy coat: both (bsdf/coated_diffuse.h)
};

/// eval:   f, per steradian, without the cosine; zero for delta lobes.
/// pdf:    density per steradian with which sample() would choose w_to, given w_from.
/// sample: turns u into w_to; nothing when absorbed.
/// scattering: how paths treat it.
/// gathers: whether eval() can be other than zero, by the signs of w_from.z and w_to.z alone.
template <class B>
concept BsdfModel = std::copyable<B> &&
    requires(const B& b, const Vec3& w, Transport t, const BsdfDraw& draw, float z) {
    { b.eval(w, w, t) } -> std::same_as<Spectrum>;
    { b.pdf(w, w, t) } -> std::same_as<float>;
    { b.sample(w, draw) } -> std::same_as<std::optional<BsdfSample>>;
    { b.scattering() } -> std::same_as<Scattering>;
    { b.gathers(z, z) } -> std::same_as<bool>;
};

/// One that bends each lane another way. for_lane(i) is the same with lane i's index in all lanes.
template <class B>
concept DispersiveModel = BsdfModel<B> && requires(const B& b, std::size_t lane) {
    { b.is_dispersive() } -> std::same_as<bool>;
    { b.for_lane(lane) } -> std::same_as<B>;
};

/// One of two delta lobes: sample() reflects if draw.u.x is below mirror_share(), else refracts.
template <class B>
concept TwoLobedModel = BsdfModel<B> &&
    requires(const B& b, const Vec3& w, const LaneChoice& lanes) {
    { b.mirror_share(w, lanes) } -> std::same_as<float>;
};

}  // namespace sunfleck
