// The scene at the wavelengths of one pass: every curve evaluated once, textures where they are
// met.
#pragma once

#include "scene/bsdf_store.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

struct PassScene {
    const Scene& scene;
    Wavelengths wavelengths;
    /// By material; nothing for an interface or a mix, and for one that varies over its surfaces or
    /// bends their shading.
    std::vector<std::optional<Bsdf>> bsdfs;
    std::vector<SampledSpectrum> emission;    // by light: its curve
    std::vector<SampledSpectrum> absorption;  // by medium, per unit of length
    SampledSpectrum white;                    // D65 of luminance one

    PassScene(const Scene& of, PassId pass);

    /// What scatters at a hit on what is no interface. Where the material varies, it is made in
    /// `room`, which must last as long as it is used; where it has a relief, the hit's shading
    /// normal and tangent are bent.
    const Bsdf& bsdf_at(Hit& hit, std::optional<Bsdf>& room) const {
        const auto& constant = bsdfs[scene.material_of(hit)];
        return constant ? *constant : make_bsdf(hit, room);
    }

    /// Can what scatters at some hit on the material gather? A photon is stored at all of its
    /// surfaces then, whatever scatters where it arrives (docs/method/method.md, surfaces that are
    /// there in part).
    bool may_gather(std::uint32_t material) const { return may_gather_[material]; }

    /// What a light emits, in the colour that it has there.
    SampledSpectrum tinted(const SampledSpectrum& emitted, const std::optional<Vec3>& tint) const {
        return tint ? emitted * colour(*tint) : emitted;
    }

    /// What an area light emits where it is met.
    SampledSpectrum emitted(std::uint32_t index, const AreaLight& light, const Hit& hit) const {
        if (!light.picture) return emission[index];
        const TexelLight here = light.light_at(hit.uv);
        return tinted(emission[index] * static_cast<float>(here.luminance), here.tint);
    }

    /// Share of the light that is left after a way through a medium; of an endless way, too.
    SampledSpectrum transmittance(MediumNumber medium, float distance) const {
        return sunfleck::engine::transmittance(absorption[medium], distance);
    }
    /// The medium in which light leaves a light, and what is left of its flux: that from afar has
    /// come an endless way already.
    MediumNumber start_medium(std::size_t light, const Emission& start,
                              SampledSpectrum& flux) const;
    /// Share of the light of a point that arrives at a hit from there: nothing where something is
    /// in the way but surfaces passed straight; less where media are.
    /// @param direction  to the point, unit. @param medium  in which the way there starts.
    SampledSpectrum seen_from(const Hit& hit, const Vec3& direction, float distance,
                              MediumNumber medium) const;

    /// A number by which kept() finds the Bsdf of a hit, or one of its layers, for as long as the
    /// pass lasts: that of the material, or, where this varies, of a copy. Any number of threads.
    std::uint32_t keep(const Hit& hit, const Bsdf& bsdf) const {
        const std::uint32_t material = scene.material_of(hit);
        if (!bsdfs[material]) return static_cast<std::uint32_t>(bsdfs.size()) + kept_.add(bsdf);
        if (scattering(*bsdfs[material]) != Scattering::coated) return material;
        return layers_[material] + (std::holds_alternative<CoatedBase>(bsdf) ? 0 : 1);
    }
    /// The Bsdf of a number that keep() gave.
    const Bsdf& kept(std::uint32_t number) const {
        return number < bsdfs.size() ? *bsdfs[number] : kept_[number - bsdfs.size()];
    }

private:
    SampledSpectrum colour(const Vec3& rgb) const;
    const Bsdf& make_bsdf(Hit& hit, std::optional<Bsdf>& room) const;

    bool find_whether_gathers(std::uint32_t material) const;

    std::vector<char> may_gather_;           // by material
    std::vector<std::optional<Bsdf>> bent_;  // by material: constant, but with a relief
    std::vector<std::uint32_t> layers_;      // by material: number of a coated one's base; the top
    mutable BsdfStore kept_;  // which number a Bsdf has depends on the threads, no picture does
};

}  // namespace sunfleck::engine
