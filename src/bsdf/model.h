// What a BSDF must offer, as a concept: no base class, no virtual call, no registration.
//
// Frame: the local shading frame, normal +z. wo and wi are unit vectors that both point away
// from the surface: wo back to where the path came from, wi on to where it goes.
#pragma once

#include "math/sampled_spectrum.h"
#include "math/vector.h"

#include <concepts>
#include <optional>

namespace sunfleck::engine {

/// What the path being sampled carries: radiance from the camera, flux from a light. The two differ
/// by the squared ratio of refractive indices at a refraction (Veach 1997, section 5.2).
enum class Transport { radiance, flux };

struct BsdfSample {
    SampledSpectrum weight;  // f |cos theta_to| / pdf; unitless
    Vec3 wi;
    std::optional<float> pdf;  // per steradian; none for a delta lobe, whose weight says it all
    float eta = 1;             // index of the side of wi over that of wo; 1 for reflection
    bool dispersed =
        false;  // only HeroWavelength::chosen is left in weight (already times kWavelengths)
};

/// The numbers that one scattering event may use: u in (0,1)^3 (lobe, direction, direction).
struct BsdfSampleInput {
    Vec3 u;
    Transport transport = Transport::radiance;
    HeroWavelength hero;
};

/// How a path treats the surface.
enum class Scattering {
    specular,  // only delta lobes: always continue
    glossy,    // narrow, perhaps beside a delta lobe: gather or continue (docs/method/method.md,
               // owners)
    diffuse,   // wide: gather
    coated     // diffuse under a specular or glossy coat: both (bsdf/coated_diffuse.h)
};

/// eval:   f, per steradian, without the cosine; zero for delta lobes.
/// pdf:    density per steradian with which sample() would choose wi, given wo.
/// sample: turns u into wi; nothing when absorbed.
/// scattering: how paths treat it.
/// gathers: whether eval() can be other than zero, by the signs of wo.z and wi.z alone.
/// diffuse_albedo: the diffuse albedo: share of the light of each wavelength that the wide lobe
///               scatters, seen from wo. Zero where there is no wide lobe.
/// reflection_probability: the probability with which sample() takes the first of two delta lobes,
/// a
///               reflection: with draw.u.x below it. Zero where there are no two.
template <class B>
concept BsdfModel = std::copyable<B> &&
    requires(const B& b, const Vec3& w, Transport t, const BsdfSampleInput& draw, float z,
             const HeroWavelength& hero) {
    { b.eval(w, w, t) } -> std::same_as<SampledSpectrum>;
    { b.pdf(w, w, t) } -> std::same_as<float>;
    { b.sample(w, draw) } -> std::same_as<std::optional<BsdfSample>>;
    { b.scattering() } -> std::same_as<Scattering>;
    { b.gathers(z, z) } -> std::same_as<bool>;
    { b.diffuse_albedo(w) } -> std::same_as<SampledSpectrum>;
    { b.reflection_probability(w, hero) } -> std::same_as<float>;
};

/// One that bends each wavelength another way. at_wavelength(i) is the same with wavelength i's
/// index in all wavelengths.
template <class B>
concept DispersiveModel = BsdfModel<B> && requires(const B& b, std::size_t wavelength) {
    { b.is_dispersive() } -> std::same_as<bool>;
    { b.at_wavelength(wavelength) } -> std::same_as<B>;
};

}  // namespace sunfleck::engine
