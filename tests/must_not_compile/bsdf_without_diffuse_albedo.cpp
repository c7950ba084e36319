// A diffuse BSDF that does not say its albedo is refused on the line where it joins the variant.
// Refused with: does not satisfy|constraint|BsdfModel
#include "bsdf/bsdf.h"

namespace sunfleck::engine {

struct Chalk {
    SampledSpectrum eval(const Vec3&, const Vec3&, Transport) const { return SampledSpectrum(); }
    float pdf(const Vec3&, const Vec3&, Transport) const { return 0; }
    std::optional<BsdfSample> sample(const Vec3&, const BsdfSampleInput&) const { return {}; }
    static Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float, float) { return true; }
#ifndef FAULT
    static SampledSpectrum diffuse_albedo(const Vec3&) {
        return SampledSpectrum(0.5F);
    }
#endif
    static float reflection_probability(const Vec3&, const HeroWavelength&) {
        return 0;
    }
};

using WithChalk = BsdfVariant<Lambert, Chalk>;
static_assert(std::variant_size_v<WithChalk> == 2);

}  // namespace sunfleck::engine
