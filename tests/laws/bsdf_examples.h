// Examples of every BSDF, which the laws of tests/laws/bsdf_*_test.cpp run over, and what all of
// those tests draw from.
#pragma once

#include "bsdf/bsdf.h"
#include "bsdf/facet_losses.h"
#include "core/random.h"
#include "math/warp.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::engine::laws {

struct BsdfExample {
    std::string name;
    /// Only the test that looks makes it: the table of what facets lose takes its time.
    std::function<Bsdf()> make;
    SampledSpectrum inside = SampledSpectrum(1);  // index of the side -z over that of +z
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
inline void PrintTo(const BsdfExample& example, std::ostream* out) {
    *out << example.name;
}

inline std::string name_of(const auto& info) {
    return info.param.name;
}

/// From first to last, evenly over the wavelengths.
inline SampledSpectrum ramp(float first, float last) {
    SampledSpectrum s;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        s[i] = first + (last - first) * static_cast<float>(i) / (kWavelengths - 1);
    return s;
}

inline SampledSpectrum gold_eta() {
    return ramp(1.6F, 0.15F);
}
inline SampledSpectrum gold_k() {
    return ramp(1.9F, 4.5F);
}

struct Coats {
    Coat smooth{1.5F, {}, 0};
    Coat rough{1.5F, Ggx{0.3F, 0.3F}, 0.01F};
    Coat frosted{1.5F, Ggx{0.8F, 0.8F}, 0.01F};
    Coat oily{1.33F, Ggx{0.4F, 0.4F}, 0};

    /// The albedo under the oily coat that sends back all that enters (material/material.cpp).
    float whole_below_oil() const {
        const float leaving = oily.mean_entering() / (oily.eta() * oily.eta());
        return 1 / (leaving + oily.returning());
    }
};

inline const Coats& coats() {
    static const Coats made;
    return made;
}

inline std::function<Bsdf()> fixed(const Bsdf& bsdf) {
    return [bsdf] { return bsdf; };
}
inline std::function<Bsdf()> kept_metal(const SampledSpectrum& eta, const SampledSpectrum& k,
                                        Ggx facets) {
    return [=] { return RoughConductor{eta, k, facets, &FacetLosses::table()}; };
}
inline std::function<Bsdf()> kept_soapy(const ThinFilm& film, Ggx facets) {
    return [=] { return IridescentConductor{ramp(1, 4), film, facets, &FacetLosses::table()}; };
}
inline std::function<Bsdf()> kept_glass(const SampledSpectrum& eta, Ggx facets) {
    return [=] { return RoughDielectric(eta, facets, &FacetLosses::table()); };
}

// One line an example. All numbers are made up but those of gold's order of magnitude.

/// Those that have delta lobes alone.
inline std::vector<BsdfExample> delta_examples() {
    const SampledSpectrum glass(1.5F);
    const SampledSpectrum bubble(1 / 1.33F);
    const SampledSpectrum flint = ramp(1.62F, 1.54F);
    return {
        {"glass", fixed(SmoothDielectric(glass)), glass},
        {"bubble", fixed(SmoothDielectric(bubble)), bubble},
        {"prism", fixed(SmoothDielectric(flint)), flint},
        {"pane", fixed(ThinDielectric{glass})},
        {"coloured_pane", fixed(ThinDielectric{ramp(1.3F, 1.9F)})},
        {"bottle_pane", fixed(ThinDielectric{ramp(1.3F, 1.9F), ramp(0.1F, 0.8F)})},
        {"mirror", fixed(SmoothConductor{SampledSpectrum(1), SampledSpectrum(2000)})},
        {"gold", fixed(SmoothConductor{gold_eta(), gold_k()})},
        {"coated_gold", fixed(CoatedConductor(gold_eta(), gold_k(), {}, &coats().smooth))},
        {"varnish", fixed(CoatReflection{&coats().smooth})},
    };
}

/// Those that spread light over a solid angle.
inline std::vector<BsdfExample> spread_examples() {
    const SampledSpectrum glass(1.5F);
    const SampledSpectrum bubble(1 / 1.33F);
    const SampledSpectrum flint = ramp(1.62F, 1.54F);
    return {
        {"grey", fixed(Lambert{ramp(0.2F, 0.8F)})},
        {"white", fixed(Lambert{SampledSpectrum(1)})},
        {"rough_glass", fixed(RoughDielectric(glass, {0.3F, 0.3F})), glass},
        {"brushed_glass", fixed(RoughDielectric(glass, {0.1F, 0.4F})), glass},
        {"rough_bubble", fixed(RoughDielectric(bubble, {0.25F, 0.15F})), bubble},
        {"rough_prism", fixed(RoughDielectric(flint, {0.2F, 0.2F})), flint},
        {"rough_mirror",
         fixed(RoughConductor{SampledSpectrum(1), SampledSpectrum(2000), {0.5F, 0.1F}})},
        {"rough_gold", fixed(RoughConductor{gold_eta(), gold_k(), {0.2F, 0.2F}})},
        {"chalky_gold", fixed(RoughConductor{gold_eta(), gold_k(), {1, 0.6F}})},
        {"kept_mirror", kept_metal(SampledSpectrum(1), SampledSpectrum(2000), {0.5F, 0.5F})},
        {"kept_gold", kept_metal(gold_eta(), gold_k(), {0.2F, 0.2F})},
        {"kept_brushed_gold", kept_metal(gold_eta(), gold_k(), {1, 0.6F})},
        {"haze", fixed(HenyeyGreenstein{0})},
        {"mist", fixed(HenyeyGreenstein{0.8F})},
        {"dust", fixed(HenyeyGreenstein{-0.5F})},
        {"soapy_mirror",
         fixed(IridescentConductor{SampledSpectrum(2000), {1.5F, ramp(1, 0.5F)}, {0.3F, 0.3F}})},
        {"soapy_metal", kept_soapy({1.33F, ramp(0.9F, 0.4F)}, {0.4F, 0.2F})},
        {"frosted_glass", kept_glass(glass, {0.5F, 0.5F}), glass},
        {"frosted_bubble", kept_glass(bubble, {0.25F, 0.25F}), bubble},
        {"frosted_prism", kept_glass(flint, {0.4F, 0.4F}), flint},
        {"leaf", fixed(DiffuseTransmission{ramp(0.2F, 0.5F), ramp(0.4F, 0.1F)})},
        {"milk_glass", fixed(DiffuseTransmission{SampledSpectrum(0.05F), SampledSpectrum(0.9F)})},
        {"hair", fixed(DiffuseTransmission{ramp(0.25F, 0.13F), ramp(0.74F, 0.2F)})},
        {"skin", fixed(CoatedDiffuse{ramp(0.9F, 0.3F), &coats().oily})},
        {"white_skin",
         fixed(CoatedDiffuse{SampledSpectrum(coats().whole_below_oil()), &coats().oily})},
        {"coated_rough_gold",
         fixed(CoatedConductor(gold_eta(), gold_k(), Ggx{0.3F, 0.2F}, &coats().smooth))},
        {"satin_gold", fixed(CoatedConductor(gold_eta(), gold_k(), {}, &coats().frosted))},
        {"satin_varnish", fixed(CoatReflection{&coats().rough})},
        {"varnished", fixed(CoatedBase{ramp(0.2F, 0.9F), &coats().smooth})},
        {"plastic", fixed(CoatedDiffuse{ramp(0.2F, 0.9F), &coats().smooth})},
        {"satin_plastic", fixed(CoatedDiffuse{ramp(0.2F, 0.9F), &coats().rough})},
    };
}

inline std::vector<BsdfExample> bsdf_examples() {
    std::vector<BsdfExample> all = spread_examples();
    for (const BsdfExample& example : delta_examples()) all.push_back(example);
    return all;
}

inline Vec3 random_direction(RandomStream& stream) {
    const double u = stream.next();
    const Vec3d w = uniform_sphere(Vec2d(u, stream.next()));
    return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
}

/// @param cosine  with +z, either sign. @param azimuth  in radians.
inline Vec3 direction_at(float cosine, float azimuth) {
    const float sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// From straight on to grazing, from both sides; the last is beyond the prism's critical angle in
/// some wavelengths and not in others.
inline std::vector<Vec3> probe_directions() {
    return {direction_at(1, 0),        direction_at(0.8F, 0.4F),   direction_at(0.35F, 2.5F),
            direction_at(0.05F, 4.0F), direction_at(-0.9F, 1.2F),  direction_at(-0.6F, 5.0F),
            direction_at(-0.2F, 3.0F), direction_at(-0.03F, 0.1F), direction_at(-0.775F, 3.3F)};
}

/// Number i of n draws: wavelengths in turn, the lobe's number stratified, the direction random.
inline BsdfSampleInput subpass_number(std::size_t i, std::size_t n, RandomStream& stream) {
    const std::size_t wavelength = i % kWavelengths;
    const std::size_t stratum = i / kWavelengths;
    const std::size_t strata = (n + kWavelengths - 1) / kWavelengths;
    const auto lobe = static_cast<float>((static_cast<double>(stratum) + stream.next()) /
                                         static_cast<double>(strata));
    const float u = stream.next_float();
    return {Vec3(lobe, u, stream.next_float()), Transport::flux, {wavelength, false}};
}

}  // namespace sunfleck::engine::laws
