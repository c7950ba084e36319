// A BSDF whose pdf() cannot be told from a weight of eight wavelengths is refused.
// Refused with: constraint|BsdfModel
#include "bsdf/bsdf.h"

namespace sunfleck::engine {

#ifdef FAULT
using Density = SampledSpectrum;
#else
using Density = float;
#endif

struct Muddled {
    SampledSpectrum eval(const Vec3&, const Vec3&, Transport) const { return SampledSpectrum(); }
    Density pdf(const Vec3&, const Vec3&, Transport) const { return Density(0); }
    std::optional<BsdfSample> sample(const Vec3&, const BsdfSampleInput&) const { return {}; }
    static Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float, float) { return false; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return SampledSpectrum(); }
    static float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

using WithMuddled = BsdfVariant<Muddled>;
static_assert(std::variant_size_v<WithMuddled> == 1);

}  // namespace sunfleck::engine
