// Laws of every BSDF: both transports agree, nothing gains energy, samples say what eval() says.
//
// Fixed seeds; what is statistical here states its error where it is tested.
#include "laws/bsdf_examples.h"
#include "math/statistics.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine::laws {
namespace {

class BsdfLaws : public testing::TestWithParam<BsdfExample> {
protected:
    const Bsdf& bsdf() const { return bsdf_; }
    float index(float z, std::size_t wavelength) const {
        return z > 0 ? 1 : GetParam().inside[wavelength];
    }

    const Bsdf bsdf_ = GetParam().make();
    RandomStream stream_{1, Purpose::test, 0, 0};
};

void expect_close(float a, float b, float relative) {
    EXPECT_NEAR(a, b, relative * std::max(std::abs(a), std::abs(b)));
}

TEST(BsdfExamples, cover_every_alternative) {
    std::set<std::size_t> seen;
    std::set<std::string> names;
    for (const BsdfExample& e : bsdf_examples()) {
        seen.insert(e.make().index());
        EXPECT_TRUE(names.insert(e.name).second) << e.name;
    }
    EXPECT_EQ(seen.size(), std::variant_size_v<Bsdf>);
}

TEST(BsdfExamples, stand_where_they_belong) {
    for (const BsdfExample& e : delta_examples())
        EXPECT_EQ(scattering(e.make()), Scattering::specular) << e.name;
    for (const BsdfExample& e : spread_examples())
        EXPECT_NE(scattering(e.make()), Scattering::specular) << e.name;
}

/// Radiance gathered from b towards a is flux sent from b towards a.
TEST_P(BsdfLaws, camera_and_photon_paths_agree) {
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random_direction(stream_);
        const Vec3 b = random_direction(stream_);
        const SampledSpectrum gathered = eval(bsdf(), a, b, Transport::radiance);
        const SampledSpectrum sent = eval(bsdf(), b, a, Transport::flux);
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
            expect_close(gathered[wavelength], sent[wavelength], 1e-5F);
    }
}

/// f / eta^2 is the same both ways, eta of the side that the light goes out into.
TEST_P(BsdfLaws, reciprocity) {
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random_direction(stream_);
        const Vec3 b = random_direction(stream_);
        const SampledSpectrum to_a = eval(bsdf(), a, b, Transport::radiance);
        const SampledSpectrum to_b = eval(bsdf(), b, a, Transport::radiance);
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
            const float at_a = index(a.z, wavelength);
            const float at_b = index(b.z, wavelength);
            expect_close(to_a[wavelength] / (at_a * at_a), to_b[wavelength] / (at_b * at_b), 1e-5F);
        }
    }
}

/// The lobe is stratified, so smooth ones are exact to 1e-4, and every weight of the white Lambert
/// is one; of others the mean has an error, of which four are allowed.
TEST_P(BsdfLaws, no_wavelength_gains_energy) {
    constexpr std::size_t kSamples = 1U << 14U;
    for (const Vec3& wo : probe_directions()) {
        std::array<RunningMean, kWavelengths> means;
        for (std::size_t i = 0; i < kSamples; ++i) {
            const auto drawn = sample(bsdf(), wo, subpass_number(i, kSamples, stream_));
            for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
                means.at(wavelength).add(drawn ? drawn->weight[wavelength] : 0);
        }
        const bool spreads = scattering(bsdf()) != Scattering::specular;
        for (const RunningMean& mean : means)
            EXPECT_LE(mean.mean(), 1 + 1e-3 + (spreads ? 4 * mean.standard_error() : 0)) << wo;
    }
}

/// What a wide lobe scatters is the mean weight of its samples; others have none. Of the base of a
/// coat, whose albedo is a closed form of a table, 0.1% more is allowed.
TEST_P(BsdfLaws, the_diffuse_albedo_is_the_albedo_of_the_wide_lobe) {
    constexpr std::size_t kSamples = 1U << 14U;
    const Scattering kind = scattering(bsdf());
    if (kind == Scattering::coated) return;  // its base is an example of its own
    for (const Vec3& wo : probe_directions()) {
        const SampledSpectrum share = diffuse_albedo(bsdf(), wo);
        if (kind != Scattering::diffuse) {
            EXPECT_TRUE(share.is_zero()) << wo;
            continue;
        }
        std::array<RunningMean, kWavelengths> means;
        for (std::size_t i = 0; i < kSamples; ++i) {
            const auto drawn = sample(bsdf(), wo, subpass_number(i, kSamples, stream_));
            for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
                means.at(wavelength).add(drawn ? drawn->weight[wavelength] : 0);
        }
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
            const RunningMean& mean = means.at(wavelength);
            EXPECT_NEAR(share[wavelength], mean.mean(), 1e-3 + 4 * mean.standard_error()) << wo;
        }
    }
}

/// Weight, pdf, eta and side of a sample are those that eval() and pdf() give for it.
TEST_P(BsdfLaws, samples_say_what_eval_and_pdf_say) {
    constexpr std::size_t kSamples = 4000;
    const Scattering kind = scattering(bsdf());
    for (std::size_t i = 0; i < kSamples; ++i) {
        BsdfSampleInput draw = subpass_number(i, kSamples, stream_);
        draw.transport = i % 3 == 0 ? Transport::radiance : Transport::flux;
        const Vec3 wo = random_direction(stream_);
        const auto drawn = sample(bsdf(), wo, draw);
        if (!drawn) continue;
        EXPECT_NEAR(drawn->wi.length(), 1, 1e-6F);
        EXPECT_TRUE(drawn->weight.is_finite() && drawn->weight.min() >= 0);
        const std::size_t wavelength = draw.hero.chosen;
        expect_close(drawn->eta, index(drawn->wi.z, wavelength) / index(wo.z, wavelength), 1e-6F);
        const bool delta = !drawn->pdf;
        ASSERT_TRUE(kind != Scattering::specular || delta);
        ASSERT_TRUE(kind != Scattering::diffuse || !delta);
        if (delta) {
            if (kind != Scattering::specular) continue;  // another lobe may go there, too
            EXPECT_TRUE(eval(bsdf(), wo, drawn->wi, draw.transport).is_zero());
            EXPECT_EQ(pdf(bsdf(), wo, drawn->wi, draw.transport), 0);
            continue;
        }
        // A dispersed sample says what its wavelength alone would say, for all wavelengths.
        const Bsdf one = drawn->dispersed ? at_wavelength(bsdf(), wavelength) : bsdf();
        const float share = drawn->dispersed ? static_cast<float>(kWavelengths) : 1;
        const float density = pdf(one, wo, drawn->wi, draw.transport);
        const SampledSpectrum f = eval(one, wo, drawn->wi, draw.transport);
        expect_close(*drawn->pdf, density, 2e-3F);
        for (std::size_t l = 0; l < kWavelengths; ++l) {
            const bool kept = !drawn->dispersed || l == wavelength;
            const float says = f[l] * cosine_of(one, drawn->wi) / density * share;
            expect_close(drawn->weight[l], kept ? says : 0, 2e-3F);
        }
    }
}

TEST_P(BsdfLaws, gathers_tells_where_eval_is_not_zero) {
    std::array<bool, 4> lit{};
    const auto sides = [](float a, float b) {
        return std::size_t{a > 0 ? 2U : 0U} + std::size_t{b > 0 ? 1U : 0U};
    };
    for (int i = 0; i < 4000; ++i) {
        const Vec3 a = random_direction(stream_);
        const Vec3 b = random_direction(stream_);
        if (!eval(bsdf(), a, b, Transport::radiance).is_zero()) lit.at(sides(a.z, b.z)) = true;
    }
    for (const float a : {-0.5F, 0.5F})
        for (const float b : {-0.5F, 0.5F})
            EXPECT_EQ(gathers(bsdf(), a, b), lit.at(sides(a, b))) << a << " " << b;
    EXPECT_EQ(gathers(bsdf(), 0.5F, 0), is_of_medium(bsdf()));
}

/// A path that has lost its other wavelengths goes on as if the BSDF had that wavelength's index
/// alone.
TEST_P(BsdfLaws, a_single_wavelength_stands_alone) {
    constexpr std::size_t kSamples = 2000;
    for (std::size_t i = 0; i < kSamples; ++i) {
        BsdfSampleInput draw = subpass_number(i, kSamples, stream_);
        draw.hero.single = true;
        const Vec3 wo = random_direction(stream_);
        const std::size_t wavelength = draw.hero.chosen;
        const auto here = sample(bsdf(), wo, draw);
        const auto alone = sample(at_wavelength(bsdf(), wavelength), wo, draw);
        ASSERT_EQ(here.has_value(), alone.has_value());
        if (!here) continue;
        EXPECT_FALSE(here->dispersed);
        EXPECT_TRUE(here->weight.is_finite());
        EXPECT_EQ(here->wi, alone->wi);
        EXPECT_EQ(here->weight[wavelength], alone->weight[wavelength]);
    }
}

/// Numbers at the very edge of the square, and directions along the surface, give no nonsense.
TEST_P(BsdfLaws, edges_are_finite) {
    for (const float lobe : {0.0F, 0x1p-24F, 0.5F, 1.0F})
        for (const float u : {0.0F, 0.5F, 1.0F})
            for (const Vec3& w : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(1, 0, 1e-7F),
                                  Vec3(0, 1, -1e-20F)}) {
                const auto drawn =
                    sample(bsdf(), w, {{lobe, u, 1 - u}, Transport::flux, {3, false}});
                if (!drawn) continue;
                EXPECT_TRUE(drawn->weight.is_finite()) << w << lobe << u;
                EXPECT_NEAR(drawn->wi.length(), 1, 1e-6F) << w << lobe << u;
                EXPECT_TRUE(!drawn->pdf || std::isfinite(*drawn->pdf)) << w << lobe << u;
            }
}

/// Markov chains move in u: a small move turns the direction a little, but at the horizon, where
/// lobes are cut and square roots are steep.
TEST_P(BsdfLaws, direction_is_continuous_in_u) {
    constexpr std::size_t kSamples = 20000;
    std::size_t jumps = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        BsdfSampleInput draw = subpass_number(i, kSamples, stream_);
        const Vec3 wo = random_direction(stream_);
        const auto here = sample(bsdf(), wo, draw);
        draw.u += Vec3(0, 1e-4F, -1e-4F);
        const auto near = sample(bsdf(), wo, draw);
        if (!here || !near || here->wi.z * near->wi.z <= 0) continue;
        if ((here->wi - near->wi).length() > 100 * 1e-4F) ++jumps;
    }
    EXPECT_LE(jumps, kSamples / 500);
}

INSTANTIATE_TEST_SUITE_P(All, BsdfLaws, testing::ValuesIn(bsdf_examples()),
                         [](const auto& info) { return name_of(info); });

}  // namespace
}  // namespace sunfleck::engine::laws
