// What rough facets lose and what is given back: with it, a white metal and glass lose nothing.
//
// No chance: f |cos| is added up over the sphere, 300 steps of the polar angle by 150 of azimuth.
// The tolerance is that of the table (docs/develop/decisions.md); of glass, 0.005 for these steps,
// too.
#include "bsdf/facet_losses.h"

#include "bsdf/bsdf.h"
#include "laws/bsdf_examples.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Shares of the light from w that go on, of wavelength 0.
struct Shares {
    double back = 0;
    double through = 0;
    double all() const { return back + through; }
};

Shares shares(const Bsdf& bsdf, const Vec3& w, Transport transport = Transport::flux) {
    constexpr int kRows = 300;
    constexpr int kColumns = 150;
    Shares sum;
    for (int i = 0; i < kRows; ++i) {
        const float polar = (static_cast<float>(i) + 0.5F) * kPi / kRows;
        const float area = std::sin(polar) * (kPi / kRows) * (2 * kPi / kColumns);
        for (int j = 0; j < kColumns; ++j) {
            const float turn = (static_cast<float>(j) + 0.5F) * 2 * kPi / kColumns;
            const Vec3 to = laws::direction_at(std::cos(polar), turn);
            const float f = eval(bsdf, w, to, transport)[0];
            (to.z * w.z > 0 ? sum.back : sum.through) +=
                static_cast<double>(f * std::abs(to.z) * area);
        }
    }
    return sum;
}

RoughConductor white(const Ggx& facets) {
    return {SampledSpectrum(1), SampledSpectrum(1e4F), facets, &FacetLosses::table()};
}

RoughDielectric glass(float eta, float alpha) {
    return {SampledSpectrum(eta), {alpha, alpha}, &FacetLosses::table()};
}

TEST(FacetLosses, white_metal_returns_all) {
    for (const float alpha : {0.2F, 0.5F, 0.77F, 1.0F})
        for (const float z : {1.0F, -0.7F, 0.35F, 0.15F})
            EXPECT_NEAR(shares(white({alpha, alpha}), laws::direction_at(z, 1)).all(), 1, 0.003)
                << alpha << ' ' << z;
}

/// Without, it loses a third: the test above has something to see.
TEST(FacetLosses, are_what_was_lost) {
    RoughConductor metal = white({0.5F, 0.5F});
    metal.losses = nullptr;
    const Vec3 w = laws::direction_at(0.7F, 1);
    const double lost = 1 - shares(metal, w).all();
    EXPECT_GT(lost, 0.3);
    EXPECT_NEAR(FacetLosses::table().of_mirror(metal.facets, 0.7F), lost, 0.002);
}

TEST(FacetLosses, glass_passes_on_all_from_either_side) {
    for (const float eta : {1.5F, 1.33F, 2.42F, 0.75F})
        for (const float alpha : {0.3F, 0.5F, 0.9F})
            for (const float z : {1.0F, -0.95F, 0.6F, -0.6F, 0.25F, -0.25F})
                EXPECT_NEAR(shares(glass(eta, alpha), laws::direction_at(z, 1)).all(), 1, 0.008)
                    << eta << ' ' << alpha << ' ' << z;
}

/// Radiance is smaller on the thinner side by the squared index: an even sky stays even.
TEST(FacetLosses, glass_shows_an_even_sky) {
    const Bsdf frosted = glass(1.5F, 0.5F);
    for (const float z : {0.9F, 0.4F}) {
        const Shares above = shares(frosted, laws::direction_at(z, 1), Transport::radiance);
        EXPECT_NEAR(above.back + above.through * 2.25, 1, 0.006);
        const Shares below = shares(frosted, laws::direction_at(-z, 1), Transport::radiance);
        EXPECT_NEAR(below.back + below.through / 2.25, 1, 0.006);
    }
}

/// Neither side gives more to the other than a smooth boundary does of evenly spread light.
TEST(FacetLosses, what_passes_is_bounded_by_smooth_glass) {
    for (const float eta : {1.5F, 0.7F})
        for (const float z : {1.0F, -1.0F}) {
            const Ggx facets{0.5F, 0.5F};
            const GlassCompensation lobe{FacetLosses::table(), facets, eta};
            const float smooth = 1 - mean_dielectric_reflectance(z > 0 ? eta : 1 / eta);
            EXPECT_LE(lobe.passing(z), smooth * 1.0001F);
            EXPECT_GT(lobe.passing(z), 0.05F);
        }
}

/// Brushed metal: even in the mean, in a single direction off by what docs/develop/decisions.md
/// says.
TEST(FacetLosses, brushed_metal_is_white_in_the_mean) {
    const Bsdf brushed = white({0.5F, 0.2F});
    double mean = 0;
    constexpr int kAngles = 8;
    for (int i = 0; i < kAngles; ++i) {
        const float z = std::sqrt((static_cast<float>(i) + 0.5F) / kAngles);
        for (const float turn : {0.26F, 0.79F, 1.31F}) {
            const double all = shares(brushed, laws::direction_at(z, turn)).all();
            EXPECT_NEAR(all, 1, z > 0.5F ? 0.02 : 0.06) << z << ' ' << turn;
            mean += all / (3 * kAngles);
        }
    }
    EXPECT_NEAR(mean, 1, 0.01);
}

/// Gold deepens: what is reflected more often is redder.
TEST(FacetLosses, colours_deepen) {
    const RoughConductor gold{laws::gold_eta(), laws::gold_k(), {0.7F, 0.7F}};
    const MetalCompensation lobe{FacetLosses::table(), gold.facets};
    const SampledSpectrum once = conductor_reflectance(0.7F, gold.eta, gold.k);
    const SampledSpectrum again = lobe.reflectance(gold.mirror().reflectance);
    EXPECT_LT(again[0] / again[kWavelengths - 1], once[0] / once[kWavelengths - 1]);
    const auto all = [](float) { return SampledSpectrum(1); };
    EXPECT_NEAR(lobe.reflectance(all)[0], 1, 0.001);
}

}  // namespace
}  // namespace sunfleck::engine
