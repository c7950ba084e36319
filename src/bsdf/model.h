// BsdfModel: the concept that BSDFs satisfy; there is no base class and no virtual call.
//
// The frame is the local shading frame, with the normal +z. wo and wi are unit vectors that both
// point away from the surface: wo to the previous vertex of the path, wi to the next.
#pragma once

#include "math/sampled_spectrum.h"
#include "math/vector.h"

#include <concepts>
#include <optional>

namespace sunfleck::engine {

/// Quantity that a sampled path carries: radiance from the camera, flux from a light. The two
/// differ by the squared ratio of refractive indices at a refraction (Veach 1997, section 5.2).
enum class Transport { radiance, flux };

/// Sampled direction, with its weight.
struct BsdfSample {
    SampledSpectrum weight;  // f |cos theta_to| / pdf; unitless
    Vec3 wi;
    std::optional<float> pdf;  // per steradian; none for a delta lobe
    float eta = 1;             // index of the side of wi over that of wo; 1 for reflection
    bool dispersed =
        false;  // only HeroWavelength::chosen is left in weight (already times kWavelengths)
};

/// Input of sample(): random numbers u in (0,1)^3 (lobe, direction, direction), what the path
/// carries, and its hero wavelength.
struct BsdfSampleInput {
    Vec3 u;
    Transport transport = Transport::radiance;
    HeroWavelength hero;
};

/// How camera paths treat a surface: they gather photons there, continue, or both.
enum class Scattering {
    specular,  // only delta lobes: continue
    // A narrow lobe, perhaps with a delta lobe: gather or continue (docs/method/method.md, which
    // estimator brings which light).
    glossy,
    diffuse,  // a wide lobe: gather
    coated    // diffuse under a specular or glossy coat: both (bsdf/coated_diffuse.h)
};

/// eval:   f, per steradian, without the cosine; zero for delta lobes.
/// pdf:    density per steradian with which sample() would choose wi, given wo.
/// sample: maps u to wi; nothing when the path is absorbed.
/// scattering: how camera paths treat the surface.
/// gathers: whether eval() can be nonzero, by the signs of wo.z and wi.z alone.
/// diffuse_albedo: albedo of the diffuse lobe at each wavelength, seen from wo; zero without one.
/// reflection_probability: probability with which sample() chooses reflection from two delta lobes:
///         where draw.u.x is below it. Zero without two delta lobes.
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

/// A phase function: scattering at a point of a medium.
template <class B>
concept VolumeModel = BsdfModel<B> && requires {
    requires B::is_of_medium();
};

/// A BSDF that refracts each wavelength in another direction. at_wavelength(i) is the BSDF with the
/// refractive index of wavelength i at all wavelengths.
template <class B>
concept DispersiveModel = BsdfModel<B> && requires(const B& b, std::size_t wavelength) {
    { b.is_dispersive() } -> std::same_as<bool>;
    { b.at_wavelength(wavelength) } -> std::same_as<B>;
};

}  // namespace sunfleck::engine
