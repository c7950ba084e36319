// HenyeyGreenstein: how a medium scatters light, the phase function at a point of it.
//
// In:  directions in any frame (bsdf/model.h). Out: f per steradian, of the angle between them
// alone. A medium has no normal: no cosine belongs to f (cosine_of() of bsdf/bsdf.h). Source:
// Henyey and Greenstein, Diffuse radiation in the galaxy (1941). The square maps to directions by
// way of the even sphere, of which each circle around the way straight on becomes a smaller one, so
// that small moves stay small.
#pragma once

#include "bsdf/model.h"
#include "math/warp.h"

namespace sunfleck::engine {

struct HenyeyGreenstein {
    float g = 0;  // mean cosine of the angle by which light is bent, in (-1, 1)

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        return SampledSpectrum(density(1 + wo.dot(wi)));
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport) const { return density(1 + wo.dot(wi)); }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        const Vec3d even = uniform_sphere({double{draw.u.y}, double{draw.u.z}});
        const auto part = static_cast<float>((1 - even.z) / 2);  // uniform in [0,1]
        const float rest = 1 + g - 2 * g * part;
        const float bent = 2 * (1 - g) * (1 - g) * part * (1 + g - g * part) / (rest * rest);
        const float sine = std::sqrt(std::max(0.0F, bent * (2 - bent)));
        const Vec3 across(static_cast<float>(even.x), static_cast<float>(even.y), 0);
        const float width = across.length();
        const Frame frame(-wo);
        const Vec3 wi = width > 0 ? frame.to_world(across * (sine / width) + Vec3(0, 0, 1 - bent))
                                  : frame.to_world({0, 0, std::copysign(1.0F, 1 - bent)});
        return BsdfSample{SampledSpectrum(1), wi, density(bent)};
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    static constexpr bool is_of_medium() { return true; }
    static constexpr bool gathers(float, float) { return true; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return SampledSpectrum(1); }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

private:
    /// @param bent  one minus the cosine of the angle by which light is bent.
    float density(float bent) const {
        const float root = (1 - g) * (1 - g) + 2 * g * bent;
        return (1 - g) * (1 + g) / (4 * kPi * root * std::sqrt(root));
    }
};

}  // namespace sunfleck::engine
