// Each kind of texture against its closed form, and against values worked out apart from here.
#include "texture/texture.h"

#include "math/sigmoid_table.h"
#include "texture/kinds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TexturePoint at_uv(float u, float v) {
    return {Vec3(0), {0, 0, 1}, {u, v}};
}

TexturePoint at(const Vec3& position) {
    return {position, {0, 0, 1}, {0, 0}};
}

Wavelengths some_wavelengths() {
    return Wavelengths::of_pass({3, 1});
}

FloatTexture texture(FloatKind kind) {
    return FloatTexture(std::move(kind));
}

/// u and v themselves, as textures.
FloatTexture u_itself() {
    return texture({BilerpKind<FloatTexture>{UvMapping{}, 0, 0, 1, 1}});
}
FloatTexture v_itself() {
    return texture({BilerpKind<FloatTexture>{UvMapping{}, 0, 1, 0, 1}});
}

TEST(Texture, constants_are_themselves) {
    EXPECT_EQ(FloatTexture(3).at(at_uv(0, 0)), 3);
    EXPECT_TRUE(FloatTexture(3).is_constant());
    const SpectrumTexture red(Spectrum::rgb_albedo({0.8F, 0.1F, 0.1F}));
    EXPECT_EQ(red.at(at_uv(0, 0), some_wavelengths()), red.curve().at(some_wavelengths()));
    EXPECT_FALSE(u_itself().is_constant());
}

TEST(Texture, bilerp_is_linear_in_both) {
    const FloatTexture corners = texture({BilerpKind<FloatTexture>{UvMapping{}, 1, 2, 4, 8}});
    EXPECT_EQ(corners.at(at_uv(0, 0)), 1);
    EXPECT_EQ(corners.at(at_uv(0, 1)), 2);
    EXPECT_EQ(corners.at(at_uv(1, 0)), 4);
    EXPECT_EQ(corners.at(at_uv(1, 1)), 8);
    EXPECT_EQ(corners.at(at_uv(0.5F, 0.25F)), 0.75F * 2.5F + 0.25F * 5);
}

TEST(Texture, scales_and_mixes) {
    EXPECT_FLOAT_EQ(texture({ScaledKind<FloatTexture>{u_itself(), 3}}).at(at_uv(0.5F, 0)), 1.5F);
    const FloatTexture mix = texture({MixKind<FloatTexture>{2, 6, v_itself()}});
    EXPECT_EQ(mix.at(at_uv(0, 0)), 2);
    EXPECT_EQ(mix.at(at_uv(0, 1)), 6);
    EXPECT_FLOAT_EQ(mix.at(at_uv(0, 0.25F)), 3);
    const FloatTexture facing = texture({DirectionMixKind<FloatTexture>{1, 5, Vec3(0, 0, 1)}});
    EXPECT_EQ(facing.at(at_uv(0, 0)), 1);
    EXPECT_EQ(facing.at({Vec3(0), {1, 0, 0}, {0, 0}}), 5);
    EXPECT_FLOAT_EQ(facing.at({Vec3(0), {0.8F, 0, -0.6F}, {0, 0}}), 0.6F * 1 + 0.4F * 5);
}

TEST(Texture, checkerboards_take_turns) {
    const FloatTexture flat =
        texture({CheckerboardKind<FloatTexture>{Mapping(UvMapping{{4, 4}}), 1, 2}});
    EXPECT_EQ(flat.at(at_uv(0.1F, 0.1F)), 1);
    EXPECT_EQ(flat.at(at_uv(0.3F, 0.1F)), 2);
    EXPECT_EQ(flat.at(at_uv(0.3F, 0.4F)), 1);
    EXPECT_EQ(flat.at(at_uv(-0.1F, 0.1F)), 2);
    const FloatTexture solid = texture({CheckerboardKind<FloatTexture>{PointMapping{}, 1, 2}});
    EXPECT_EQ(solid.at(at({0.5F, 0.5F, 0.5F})), 1);
    EXPECT_EQ(solid.at(at({0.5F, 0.5F, 1.5F})), 2);
    EXPECT_EQ(solid.at(at({-0.5F, 0.5F, 1.5F})), 1);
    EXPECT_EQ(solid.at(at({-0.5F, -0.5F, 3e9F})), 1);
}

TEST(Texture, dots_lie_where_noise_puts_them) {
    const FloatTexture dots = texture({DotsKind<FloatTexture>{UvMapping{}, 1, 0}});
    // Cells whose middle is in a dot, by a program apart from this one.
    for (int t = 0; t < 3; ++t)
        for (int s = 0; s < 4; ++s) {
            const bool inside = t == 2 || (t == 1 && s == 0);
            EXPECT_EQ(dots.at(at_uv(static_cast<float>(s), static_cast<float>(t))),
                      inside ? 1.0F : 0.0F)
                << s << ' ' << t;
        }
    int inside = 0;
    constexpr int kSide = 200;
    for (int i = 0; i < kSide * kSide; ++i)
        if (dots.at(at_uv(static_cast<float>(i % kSide) * 0.503F,
                          static_cast<float>(i / kSide) * 0.503F)) > 0)
            ++inside;
    EXPECT_NEAR(inside / static_cast<double>(kSide * kSide), 0.15, 0.03);
}

TEST(Texture, noises_are_asked_in_the_frame_of_the_texture) {
    Affine map;
    map.x = {2, 0, 0};
    map.origin = {1, 0, 0};
    const PointMapping mapping{map.inverse()};
    const Vec3 local(1.3F, 2.7F, -0.4F);
    const TexturePoint there = at(Vec3(map.point(Vec3d(local))));
    EXPECT_NEAR(texture({FbmKind{mapping, {3, 0.3F}}}).at(there), -0.03731116F, 1e-4F);
    EXPECT_NEAR(texture({WrinkledKind{mapping, {8, 0.5F}}}).at(there), 0.47627202F, 1e-3F);
    EXPECT_NEAR(texture({WindyKind{mapping}}).at(there), -0.00238778F, 1e-4F);
}

/// 2 x 2, sRGB bytes: red, green above blue, grey.
std::shared_ptr<const Image> four_colours() {
    return std::make_shared<const Image>(
        Vec2i(2, 2), 3, std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255, 128, 128, 128},
        Encoding{Encoding::Kind::linear, 1});
}

TEST(Texture, images_stand_upright) {
    const FloatTexture mean = texture({FloatImageKind{{UvMapping{}, four_colours(), Wrap::clamp}}});
    EXPECT_FLOAT_EQ(mean.at(at_uv(0.25F, 0.75F)), 1.0F / 3);
    EXPECT_FLOAT_EQ(mean.at(at_uv(0.75F, 0.25F)), 128.0F / 255);
    const SpectrumImageKind kind{{UvMapping{}, four_colours(), Wrap::clamp}};
    EXPECT_EQ(image_rgb(kind, at_uv(0.25F, 0.75F)), Vec3(1, 0, 0));
    EXPECT_EQ(image_rgb(kind, at_uv(0.75F, 0.75F)), Vec3(0, 1, 0));
    EXPECT_EQ(image_rgb(kind, at_uv(0.25F, 0.25F)), Vec3(0, 0, 1));
    EXPECT_EQ(image_rgb(kind, at_uv(0.5F, 0.75F)), Vec3(0.5F, 0.5F, 0));
    SpectrumImageKind nearest = kind;
    nearest.nearest = true;
    EXPECT_EQ(image_rgb(nearest, at_uv(0.49F, 0.75F)), Vec3(1, 0, 0));
}

TEST(Texture, images_are_scaled_then_inverted) {
    const auto grey = std::make_shared<const Image>(Vec2i(1, 1), 1, std::vector<float>{0.3F});
    EXPECT_FLOAT_EQ(
        texture({FloatImageKind{{UvMapping{}, grey, Wrap::clamp, false, 2, true}}}).at(at_uv(0, 0)),
        0.4F);
    EXPECT_EQ(
        texture({FloatImageKind{{UvMapping{}, grey, Wrap::clamp, false, 9, true}}}).at(at_uv(0, 0)),
        0);
    const auto alpha =
        std::make_shared<const Image>(Vec2i(1, 1), 4, std::vector<float>{1, 1, 1, 0.25F});
    EXPECT_EQ(texture({FloatImageKind{{UvMapping{}, alpha}}}).at(at_uv(0, 0)), 0.25F);
}

TEST(Texture, colours_of_images_become_spectra_by_their_use) {
    const Wavelengths wavelengths = some_wavelengths();
    const auto bright = std::make_shared<const Image>(Vec2i(1, 1), 3, std::vector<float>{4, 2, 1});
    const auto value = [&](ColourUse use) {
        return SpectrumTexture(SpectrumKind{SpectrumImageKind{{UvMapping{}, bright}, use}})
            .at(at_uv(0, 0), wavelengths);
    };
    const SigmoidTable& table = SigmoidTable::srgb();
    EXPECT_EQ(value(ColourUse::albedo), SampledSpectrum(1));
    EXPECT_EQ(value(ColourUse::unbounded), table.unbounded({4, 2, 1}, wavelengths));
    const SampledSpectrum lit = value(ColourUse::illuminant);
    const SampledSpectrum exact = Spectrum::rgb_illuminant({4, 2, 1}).at(wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i)
        EXPECT_NEAR(lit[i], exact[i], 0.02F * exact[i] + 0.02F);
}

TEST(Texture, spectra_are_mixed_wavelength_by_wavelength) {
    const Wavelengths wavelengths = some_wavelengths();
    const Spectrum red = Spectrum::rgb_albedo({0.8F, 0.1F, 0.1F});
    const SpectrumTexture mix(
        SpectrumKind{MixKind<SpectrumTexture>{red, Spectrum::constant(0.2F), u_itself()}});
    const SampledSpectrum value = mix.at(at_uv(0.25F, 0), wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i)
        EXPECT_FLOAT_EQ(value[i], 0.75F * red.at(wavelengths)[i] + 0.25F * 0.2F);
}

TEST(Texture, marble_runs_along_y) {
    const SpectrumTexture marble(SpectrumKind{MarbleKind{PointMapping{}, {8, 0.5F}, 1, 0}});
    const Wavelengths wavelengths = some_wavelengths();
    const auto value = [&](float x, float y) { return marble.at(at({x, y, 0}), wavelengths); };
    EXPECT_EQ(value(0, 0.3F), value(7, 0.3F));
    EXPECT_NE(value(0, 0.3F), value(0, 1.3F));
    // t = 0: the first colour; t = 1: the last one; both 1.5 times (0.58, 0.58, 0.6).
    const SampledSpectrum pale = SigmoidTable::srgb().albedo({0.87F, 0.87F, 0.9F}, wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        EXPECT_NEAR(value(0, -kPi / 2)[i], pale[i], 1e-5F);
        EXPECT_NEAR(value(0, kPi / 2)[i], pale[i], 1e-5F);
    }
}

}  // namespace
}  // namespace sunfleck::engine
