// Materials at the wavelengths of a pass: which BSDF each becomes, and with what numbers.
#include "material/material.h"

#include "core/random.h"
#include "texture/kinds.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Wavelengths some_wavelengths() {
    Wavelengths w;
    for (std::size_t i = 0; i < kWavelengths; ++i) w.nm.at(i) = 400 + 40 * static_cast<float>(i);
    return w;
}

/// value(nm) = nm / 1000: wavelengths that differ, known by heart.
Spectrum rising() {
    return Spectrum::table({{300, 0.3F}, {900, 0.9F}});
}

template <class B>
B as(const Material& material) {
    const std::optional<Bsdf> bsdf = bsdf_of(material, some_wavelengths());
    EXPECT_TRUE(bsdf && std::holds_alternative<B>(*bsdf));
    return std::get<B>(*bsdf);
}

TEST(Material, diffuse_takes_its_curve_at_each_wavelength) {
    const auto b = as<Lambert>(DiffuseMaterial{rising()});
    for (std::size_t i = 0; i < kWavelengths; ++i)
        EXPECT_NEAR(b.albedo[i], 0.4F + 0.04F * static_cast<float>(i), 1e-6F);
}

TEST(Material, diffuse_is_held_in_zero_and_one) {
    EXPECT_EQ(as<Lambert>(DiffuseMaterial{Spectrum::constant(1.5F)}).albedo, SampledSpectrum(1));
    EXPECT_EQ(as<Lambert>(DiffuseMaterial{Spectrum::constant(-1)}).albedo, SampledSpectrum(0));
}

/// White below a coat without losses is white; and what is asked for, leaves.
TEST(Material, coated_diffuse_may_be_told_its_whole_reflectance) {
    for (const auto& facets : {std::optional<Ggx>(), std::optional<Ggx>({0.3F, 0.3F})}) {
        const auto coat = std::make_shared<Coat>(1.33F, facets, 0);
        for (const float whole : {0.0F, 0.3F, 0.9F, 1.0F}) {
            const auto b =
                as<CoatedDiffuse>(CoatedDiffuseMaterial{Spectrum::constant(whole), coat, true});
            const Vec3 from(0.6F, 0, 0.8F);
            const float entered = coat->entering(0.8F);
            const float left = b.base().diffuse_albedo(from)[0] / entered;
            EXPECT_NEAR(left, whole, 1e-4) << whole;
        }
    }
}

TEST(Material, dielectric_is_smooth_below_the_limit_in_both) {
    const Spectrum eta = Spectrum::constant(1.5F);
    EXPECT_EQ(as<SmoothDielectric>(DielectricMaterial{eta, {}}).eta(), SampledSpectrum(1.5F));
    as<SmoothDielectric>(DielectricMaterial{eta, {0.9e-3F, 0.9e-3F}});
    const auto rough = as<RoughDielectric>(DielectricMaterial{eta, {0, 0.2F}});
    EXPECT_EQ(rough.facets().alpha_x, 1e-4F);
    EXPECT_EQ(rough.facets().alpha_y, 0.2F);
    EXPECT_EQ(rough.eta(), SampledSpectrum(1.5F));
}

TEST(Material, dielectric_without_an_index_is_air) {
    as<SmoothDielectric>(DielectricMaterial{Spectrum::constant(1), {0.3F, 0.3F}});
    EXPECT_EQ(as<SmoothDielectric>(DielectricMaterial{Spectrum::constant(0), {}}).eta(),
              SampledSpectrum(1));
}

TEST(Material, dielectric_that_depends_on_the_wavelength_is_dispersive) {
    const Spectrum glass = Spectrum::table({{300, 1.6F}, {900, 1.5F}});
    EXPECT_TRUE(as<SmoothDielectric>(DielectricMaterial{glass, {}}).is_dispersive());
    EXPECT_TRUE(as<RoughDielectric>(DielectricMaterial{glass, {0.1F, 0.1F}}).is_dispersive());
    const Spectrum plain = Spectrum::constant(1.5F);
    EXPECT_FALSE(as<SmoothDielectric>(DielectricMaterial{plain, {}}).is_dispersive());
}

TEST(Material, thin_dielectric_keeps_its_index) {
    const Spectrum eta = Spectrum::constant(1.4F);
    EXPECT_EQ(as<ThinDielectric>(ThinDielectricMaterial{eta}).eta, SampledSpectrum(1.4F));
}

TEST(Material, conductor_by_index_and_by_reflectance) {
    ConductorMaterial metal;
    metal.eta = Spectrum::constant(0.2F);
    metal.k = rising();
    const auto smooth = as<SmoothConductor>(metal);
    EXPECT_EQ(smooth.eta, SampledSpectrum(0.2F));
    EXPECT_NEAR(smooth.k[7], 0.68F, 1e-6F);

    metal.roughness = {0.3F, 0.1F};
    metal.reflectance = Spectrum::constant(0.8F);
    const auto rough = as<RoughConductor>(metal);
    EXPECT_EQ(rough.facets.alpha_x, 0.3F);
    EXPECT_EQ(rough.facets.alpha_y, 0.1F);
    EXPECT_NEAR(conductor_reflectance(1, rough.eta, rough.k)[2], 0.8F, 1e-6F);

    metal.reflectance = Spectrum::constant(1);
    EXPECT_TRUE(as<RoughConductor>(metal).k.is_finite());
}

/// u itself.
FloatTexture u_itself() {
    return FloatTexture(FloatKind{BilerpKind<FloatTexture>{UvMapping{}, 0, 0, 1, 1}});
}

TexturePoint at_u(float u) {
    return {Vec3(0), {0, 0, 1}, {u, 0}};
}

TEST(Material, textures_are_asked_at_the_point) {
    const Wavelengths wavelengths = some_wavelengths();
    const SpectrumTexture grey_u(SpectrumKind{
        ScaledKind<SpectrumTexture>{SpectrumTexture(Spectrum::constant(1)), u_itself()}});
    const Material diffuse = DiffuseMaterial{grey_u};
    EXPECT_TRUE(is_textured(diffuse));
    EXPECT_EQ(std::get<Lambert>(*bsdf_of(diffuse, wavelengths, at_u(0.25F))).albedo,
              SampledSpectrum(0.25F));
    const Material glass = DielectricMaterial{Spectrum::constant(1.5F), {u_itself(), 0.2F}};
    EXPECT_TRUE(is_textured(glass));
    const Bsdf rough = *bsdf_of(glass, wavelengths, at_u(0.3F));
    EXPECT_EQ(std::get<RoughDielectric>(rough).facets().alpha_x, 0.3F);
    EXPECT_EQ(std::get<RoughDielectric>(rough).facets().alpha_y, 0.2F);
    ConductorMaterial metal;
    metal.reflectance = grey_u;
    metal.roughness = {u_itself(), u_itself(), true};
    EXPECT_TRUE(is_textured(metal));
    const auto shine = std::get<RoughConductor>(*bsdf_of(metal, wavelengths, at_u(0.25F)));
    EXPECT_EQ(shine.facets.alpha_x, 0.5F);
    EXPECT_NEAR(conductor_reflectance(1, shine.eta, shine.k)[2], 0.25F, 1e-6F);
    EXPECT_TRUE(std::holds_alternative<SmoothConductor>(*bsdf_of(metal, wavelengths, at_u(0))));
    metal = ConductorMaterial{grey_u, grey_u, {}, {}};
    EXPECT_EQ(std::get<SmoothConductor>(*bsdf_of(metal, wavelengths, at_u(0.75F))).k,
              SampledSpectrum(0.75F));
    EXPECT_FALSE(is_textured(DiffuseMaterial{}));
    EXPECT_FALSE(is_textured(InterfaceMaterial{}));
}

TEST(Material, interface_is_no_surface) {
    EXPECT_FALSE(bsdf_of(InterfaceMaterial{}, some_wavelengths()));
}

TEST(Material, alpha_is_the_root_of_roughness) {
    EXPECT_EQ(alpha_from_roughness(0), 0);
    EXPECT_NEAR(alpha_from_roughness(0.09F), 0.3F, 1e-7F);
}

TexturePoint somewhere(RandomStream& random) {
    return {Vec3(random.next_float(), random.next_float(), random.next_float()), {0, 0, 1}, {0, 0}};
}

/// 100,000 places: one standard error of a share is 0.0016 at most.
TEST(Mix, parts_are_met_by_their_amount) {
    constexpr int kPlaces = 100'000;
    for (const float amount : {0.0F, 0.2F, 0.5F, 1.0F}) {
        const MixMaterial mix{{3, 8}, amount};
        RandomStream random(1, Purpose::test, 0, 0);
        int second = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const TexturePoint place = somewhere(random);
            const std::uint32_t part = mix.chosen(place);
            ASSERT_TRUE(part == 3 || part == 8);
            EXPECT_EQ(mix.chosen(place), part);
            second += part == 8 ? 1 : 0;
        }
        const double share = static_cast<double>(second) / kPlaces;
        EXPECT_NEAR(share, amount, amount == 0 || amount == 1 ? 0 : 0.007) << amount;
    }
}

/// Two mixes at one place choose each for itself.
TEST(Mix, of_other_parts_choose_otherwise) {
    const MixMaterial a{{1, 2}, 0.5F};
    const MixMaterial b{{3, 4}, 0.5F};
    RandomStream random(2, Purpose::test, 0, 0);
    int both = 0;
    for (int i = 0; i < 10'000; ++i) {
        const TexturePoint place = somewhere(random);
        both += a.chosen(place) == 2 && b.chosen(place) == 4 ? 1 : 0;
    }
    EXPECT_NEAR(both, 2500, 200);
}

}  // namespace
}  // namespace sunfleck::engine
