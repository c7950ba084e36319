// The variant: each call reaches the right BSDF; what concerns only some has an answer for all.
#include "bsdf/bsdf.h"

#include "laws/bsdf_examples.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

static_assert(DispersiveModel<SmoothDielectric> && DispersiveModel<RoughDielectric>);
static_assert(!DispersiveModel<ThinDielectric> && !DispersiveModel<Lambert>);

TEST(Bsdf, scattering_tells_how_wide) {
    EXPECT_EQ(scattering(Lambert{SampledSpectrum(1)}), Scattering::diffuse);
    EXPECT_EQ(scattering(SmoothDielectric(SampledSpectrum(2))), Scattering::specular);
    EXPECT_EQ(scattering(ThinDielectric{SampledSpectrum(2)}), Scattering::specular);
    EXPECT_EQ(scattering(SmoothConductor{SampledSpectrum(1), SampledSpectrum(1)}),
              Scattering::specular);
    EXPECT_EQ(scattering(RoughConductor{SampledSpectrum(1), SampledSpectrum(1), {}}),
              Scattering::glossy);
    EXPECT_EQ(scattering(RoughDielectric(SampledSpectrum(2), {})), Scattering::glossy);
}

TEST(Bsdf, at_wavelength_ends_dispersion) {
    const SampledSpectrum flint = laws::ramp(1.7F, 1.5F);
    for (const Bsdf& prism : {Bsdf(SmoothDielectric(flint)), Bsdf(RoughDielectric(flint, {}))}) {
        EXPECT_TRUE(is_dispersive(prism));
        const Bsdf one = at_wavelength(prism, 5);
        EXPECT_FALSE(is_dispersive(one));
        EXPECT_EQ(one.index(), prism.index());
    }
    EXPECT_EQ(std::get<SmoothDielectric>(at_wavelength(SmoothDielectric(flint), 5)).eta(),
              SampledSpectrum(flint[5]));
    EXPECT_FALSE(is_dispersive(SmoothDielectric(SampledSpectrum(1.5F))));
    EXPECT_FALSE(is_dispersive(ThinDielectric{flint}));
    const Bsdf pane = at_wavelength(ThinDielectric{flint}, 5);
    EXPECT_EQ(std::get<ThinDielectric>(pane).eta, flint);
}

TEST(Bsdf, gathers_by_side) {
    const Bsdf paper = Lambert{SampledSpectrum(1)};
    EXPECT_TRUE(gathers(paper, 0.1F, 0.9F) && gathers(paper, -0.1F, -0.9F));
    EXPECT_FALSE(gathers(paper, 0.1F, -0.9F));
    EXPECT_TRUE(gathers(RoughDielectric(SampledSpectrum(1.5F), {}), 0.1F, -0.9F));
    EXPECT_FALSE(gathers(RoughConductor{SampledSpectrum(1), SampledSpectrum(1), {}}, 0.1F, -0.9F));
    EXPECT_FALSE(gathers(SmoothDielectric(SampledSpectrum(1.5F)), 0.1F, 0.9F));
}

TEST(Bsdf, lambert_is_albedo_over_pi_on_the_lit_side) {
    const Bsdf paper = Lambert{laws::ramp(0.1F, 0.9F)};
    const Vec3 up = laws::direction_at(0.3F, 1);
    EXPECT_EQ(eval(paper, up, Vec3(0, 0, 1), Transport::flux), laws::ramp(0.1F, 0.9F) / kPi);
    EXPECT_TRUE(eval(paper, -up, Vec3(0, 0, 1), Transport::flux).is_zero());
    EXPECT_LT(sample(paper, -up, {Vec3(0.5F, 0.2F, 0.3F), Transport::flux, {}})->wi.z, 0);
}

}  // namespace
}  // namespace sunfleck::engine
