// A BSDF that lacks pdf() is refused on the line where it joins the variant.
// Refused with: does not satisfy|constraint|BsdfModel
#include "bsdf/bsdf.h"

namespace sunfleck::engine {

struct Incomplete {
    SampledSpectrum eval(const Vec3&, const Vec3&, Transport) const { return SampledSpectrum(); }
#ifndef FAULT
    float pdf(const Vec3&, const Vec3&, Transport) const {
        return 0;
    }
#endif
    std::optional<BsdfSample> sample(const Vec3&, const BsdfSampleInput&) const {
        return {};
    }
    static Scattering scattering() {
        return Scattering::diffuse;
    }
    static bool gathers(float, float) {
        return false;
    }
    static SampledSpectrum diffuse_albedo(const Vec3&) {
        return SampledSpectrum();
    }
    static float reflection_probability(const Vec3&, const HeroWavelength&) {
        return 0;
    }
};

using WithIncomplete = BsdfVariant<Lambert, Incomplete>;
static_assert(std::variant_size_v<WithIncomplete> == 2);

}  // namespace sunfleck::engine
