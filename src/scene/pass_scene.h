// PassScene: the scene at the wavelengths of one pass, with each spectrum evaluated once and
// textures evaluated at hits.
#pragma once

#include "medium/free_path.h"
#include "medium/glow_along.h"
#include "scene/bsdf_store.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

struct PassScene {
    const Scene& scene;
    Wavelengths wavelengths;
    /// By material; nothing for an interface or a mix, and for a material that is textured or
    /// perturbs the shading normal.
    std::vector<std::optional<Bsdf>> bsdfs;
    std::vector<SampledSpectrum> emission;  // by light: its spectrum
    std::vector<SampledMedium> media;       // by number
    SampledSpectrum white;                  // D65 of luminance one

    PassScene(const Scene& of, PassId pass);

    /// Returns the Bsdf at a hit on a material that is not an interface. A textured one is
    /// evaluated into `room`, which must live as long as the result. A bump or normal map changes
    /// the hit's shading normal and tangent.
    const Bsdf& bsdf_at(Hit& hit, std::optional<Bsdf>& room) const {
        const auto& constant = bsdfs[scene.material_of(hit)];
        return constant ? *constant : make_bsdf(hit, room);
    }

    /// Returns whether some Bsdf of the material can gather. If so, photons are stored at all of
    /// its surfaces, whatever the Bsdf at their hits (docs/method/method.md, partial surfaces).
    bool may_gather(std::uint32_t material) const { return may_gather_[material] != 0; }

    /// Returns a light's emission times its colour at a point.
    SampledSpectrum coloured(const SampledSpectrum& emitted, const std::optional<Vec3>& rgb) const {
        return rgb ? emitted * colour(*rgb) : emitted;
    }

    /// Returns the emission of an area light at a hit.
    SampledSpectrum emitted(std::uint32_t index, const AreaLight& light, const Hit& hit) const {
        if (!light.image) return emission[index];
        const TexelLight here = light.light_at(hit.uv);
        return coloured(emission[index] * static_cast<float>(here.luminance), here.rgb);
    }

    /// Returns what the medium of a light emits at a point, over the density of the light there;
    /// nothing where there is another medium.
    std::optional<SampledSpectrum> glow_at(const MediumLight& light, const Vec3& point) const;
    /// Returns the light of a medium that emits.
    std::uint32_t light_of(MediumNumber medium) const { return light_of_medium_[medium]; }
    /// Returns what a medium leaves of light on a way, whose length may be infinite.
    SampledSpectrum transmittance(MediumNumber medium, const Ray& way) const {
        return sunfleck::engine::transmittance(media[medium], way);
    }
    /// Returns the number with which kept() finds the phase function of a medium.
    std::uint32_t phase_of(MediumNumber medium) const { return phases_ + medium; }
    /// Returns the medium in which light leaves a light, and attenuates its flux: distant light has
    /// come an infinite way already.
    MediumNumber start_medium(std::size_t light, const Emission& start,
                              SampledSpectrum& flux) const;
    /// Returns the transmittance from a point to a vertex: zero if something other than null
    /// interfaces is between them; media attenuate it.
    /// @param direction  to the point, unit.
    /// @param medium  at the hit, in the direction of the point.
    SampledSpectrum seen_from(const Hit& hit, const Vec3& direction, float distance,
                              MediumNumber medium) const;

    /// Returns a number with which kept() finds the Bsdf of a hit, or one of its layers, until the
    /// pass ends: that of the material or, if textured, of a copy. Thread-safe.
    std::uint32_t keep(const Hit& hit, const Bsdf& bsdf) const {
        const std::uint32_t material = scene.material_of(hit);
        if (!bsdfs[material]) return static_cast<std::uint32_t>(bsdfs.size()) + kept_.add(bsdf);
        if (scattering(*bsdfs[material]) != Scattering::coated) return material;
        return layers_[material] + (std::holds_alternative<CoatedBase>(bsdf) ? 0 : 1);
    }
    /// Returns the Bsdf of a number from keep().
    const Bsdf& kept(std::uint32_t number) const {
        return number < bsdfs.size() ? *bsdfs[number] : kept_[number - bsdfs.size()];
    }

private:
    SampledSpectrum colour(const Vec3& rgb) const;
    const Bsdf& make_bsdf(Hit& hit, std::optional<Bsdf>& room) const;

    bool find_whether_gathers(std::uint32_t material) const;

    std::vector<std::uint32_t> light_of_medium_;
    std::vector<char> may_gather_;           // per material
    std::vector<std::optional<Bsdf>> bent_;  // per material: constant, with a bump or normal map
    std::vector<std::uint32_t> layers_;      // per material: number of the base under a coat
    std::uint32_t phases_ = 0;               // number of the first medium's phase function
    mutable BsdfStore kept_;                 // numbers depend on the threads, pictures do not
};

}  // namespace sunfleck::engine
