// Laws of the BSDFs that have delta lobes alone: each wavelength is shared out as Fresnel says.
//
// No chance: the lobe's number and the wavelength run through all their strata. The quadrature's
// error is the largest weight over the strata, some 3e-4; the rest is float.
#include "laws/bsdf_examples.h"
#include "laws/bsdf_fresnel.h"

#include <gtest/gtest.h>

#include <array>

namespace sunfleck::engine::laws {
namespace {

constexpr std::size_t kStrata = 1U << 15U;

class BsdfDeltaLaws : public testing::TestWithParam<BsdfExample> {
protected:
    const Bsdf bsdf_ = GetParam().make();
};

/// Mean weights on the two sides, per wavelength.
struct Shares {
    std::array<double, kWavelengths> reflected{};
    std::array<double, kWavelengths> passed{};
};

/// Adds the mean over all strata of the lobe's number, times `scale`.
void add_shares(const Bsdf& bsdf, const Vec3& wo, HeroWavelength hero, double scale, Shares& sum) {
    for (std::size_t i = 0; i < kStrata; ++i) {
        const float lobe = (static_cast<float>(i) + 0.5F) / static_cast<float>(kStrata);
        const auto drawn = sample(bsdf, wo, {Vec3(lobe, 0.5F, 0.5F), Transport::flux, hero});
        if (!drawn) continue;
        auto& side = drawn->wi.z * wo.z > 0 ? sum.reflected : sum.passed;
        for (std::size_t l = 0; l < kWavelengths; ++l)
            side.at(l) += drawn->weight[l] * scale / kStrata;
    }
}

/// What one boundary, sheet or metal reflects and lets pass, in one wavelength.
struct Truth {
    double reflected = 0;
    double passed = 0;
};

Truth truth(const Bsdf& bsdf, const Vec3& wo, std::size_t wavelength) {
    const double cosine = std::abs(wo.z);
    if (const auto* glass = std::get_if<SmoothDielectric>(&bsdf)) {
        const double eta = glass->eta()[wavelength];
        const double r = fresnel(cosine, wo.z > 0 ? eta : 1 / eta);
        return {r, 1 - r};
    }
    if (const auto* sheet = std::get_if<ThinDielectric>(&bsdf)) {
        const double r = fresnel(cosine, sheet->eta[wavelength]);
        const double t = 1 - r;
        return {r + t * t * r / (1 - r * r), sheet->colour[wavelength] * t * t / (1 - r * r)};
    }
    if (const auto* varnish = std::get_if<CoatReflection>(&bsdf))
        return {fresnel(cosine, varnish->coat->eta()), 0};
    if (std::holds_alternative<CoatedConductor>(bsdf)) {
        // The example's: gold under a coat of index 1.5 that takes nothing, summed as a series.
        const double inside = std::sqrt(1 - (1 - cosine * cosine) / 2.25);
        const double top = fresnel(cosine, 1.5);
        const double r = fresnel(
            inside, std::complex<double>(gold_eta()[wavelength], gold_k()[wavelength]) / 1.5);
        double sum = top;
        double left = (1 - top) * r;
        for (int i = 0; i < 60; ++i, left *= top * r) sum += left * (1 - top);
        return {sum, 0};
    }
    const auto& metal = std::get<SmoothConductor>(bsdf);
    return {fresnel(cosine, {metal.eta[wavelength], metal.k[wavelength]}), 0};
}

/// The mean over the choice of wavelength: dispersion, total reflection and all.
TEST_P(BsdfDeltaLaws, each_wavelength_is_shared_as_fresnel_says) {
    for (const Vec3& wo : probe_directions()) {
        Shares mean;
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
            add_shares(bsdf_, wo, {wavelength, false}, 1.0 / kWavelengths, mean);
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
            const Truth exact = truth(bsdf_, wo, wavelength);
            EXPECT_NEAR(mean.reflected.at(wavelength), exact.reflected, 4e-4) << wo << wavelength;
            EXPECT_NEAR(mean.passed.at(wavelength), exact.passed, 4e-4) << wo << wavelength;
        }
    }
}

TEST_P(BsdfDeltaLaws, a_single_wavelength_is_shared_by_its_own_index) {
    for (const Vec3& wo : probe_directions())
        for (const std::size_t wavelength : {std::size_t{0}, kWavelengths - 1}) {
            Shares mean;
            add_shares(bsdf_, wo, {wavelength, true}, 1, mean);
            const Truth exact = truth(bsdf_, wo, wavelength);
            EXPECT_NEAR(mean.reflected.at(wavelength), exact.reflected, 5e-5) << wo << wavelength;
            EXPECT_NEAR(mean.passed.at(wavelength), exact.passed, 5e-5) << wo << wavelength;
        }
}

/// reflection_probability() is where sample() goes over from one lobe to the other.
TEST_P(BsdfDeltaLaws, the_lobes_split_at_the_reflection_probability) {
    for (const Vec3& wo : probe_directions())
        for (std::size_t i = 0; i < 2 * kWavelengths; ++i) {
            const HeroWavelength hero{i / 2, i % 2 == 1};
            const float share = reflection_probability(bsdf_, wo, hero);
            EXPECT_GE(share, 0);
            EXPECT_LE(share, 1);
            const auto reflects = [&](float u) {
                const auto drawn = sample(bsdf_, wo, {Vec3(u, 0.5F, 0.5F), {}, hero});
                return drawn && drawn->wi.z * wo.z > 0;
            };
            if (share == 0) continue;  // no two lobes: as the other laws say
            EXPECT_TRUE(reflects(share * 0.9999F)) << wo << i;
            if (share < 1) {
                EXPECT_FALSE(reflects(share + (1 - share) * 1e-4F)) << wo << i;
            }
        }
    const bool is_glass = std::holds_alternative<SmoothDielectric>(bsdf_) ||
                          std::holds_alternative<ThinDielectric>(bsdf_);
    EXPECT_EQ(reflection_probability(bsdf_, Vec3(0.6F, 0, 0.8F), {0, false}) > 0, is_glass);
}

/// Weights stay small enough for Russian roulette to have nothing to do: reflection at most
/// kWavelengths.
TEST_P(BsdfDeltaLaws, weights_are_bounded) {
    for (const Vec3& wo : probe_directions())
        for (std::size_t i = 0; i < 1000; ++i) {
            const float lobe = (static_cast<float>(i) + 0.5F) / 1000;
            const HeroWavelength hero{i % kWavelengths, false};
            const auto drawn = sample(bsdf_, wo, {Vec3(lobe, 0, 0), Transport::flux, hero});
            if (!drawn) continue;
            const float bound = drawn->dispersed ? kWavelengths * kWavelengths : kWavelengths;
            EXPECT_LE(drawn->weight.max(), bound * 1.0001F);
        }
}

/// A lossless BSDF without dispersion never changes a weight: not in the mean, each time.
TEST(BsdfWhiteFurnace, weights_are_exactly_one) {
    for (const BsdfExample& e : delta_examples()) {
        if (e.name != "glass" && e.name != "bubble" && e.name != "pane") continue;
        const Bsdf bsdf = e.make();
        RandomStream stream(3, Purpose::test, 0, 0);
        for (std::size_t i = 0; i < 20000; ++i) {
            const auto drawn =
                sample(bsdf, random_direction(stream), subpass_number(i, 20000, stream));
            ASSERT_TRUE(drawn);
            EXPECT_EQ(drawn->weight, SampledSpectrum(1)) << e.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, BsdfDeltaLaws, testing::ValuesIn(delta_examples()),
                         [](const auto& info) { return name_of(info); });

}  // namespace
}  // namespace sunfleck::engine::laws
