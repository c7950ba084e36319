// GGX facets: normalised, masked as Smith says, sampled as they are seen.
#include "bsdf/ggx.h"

#include "laws/bsdf_examples.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::array<Ggx, 4> kFacets{{{0.3F, 0.3F}, {0.1F, 0.5F}, {1, 1}, {0.02F, 0.02F}}};

/// D(h) in spherical angles (Walter et al. 2007, eq. 33; along x and y apart as in Heitz 2014).
double textbook_density(const Ggx& g, const Vec3d& h) {
    const double tan2_x = h.x * h.x / (h.z * h.z) / (double{g.alpha_x} * g.alpha_x);
    const double tan2_y = h.y * h.y / (h.z * h.z) / (double{g.alpha_y} * g.alpha_y);
    const double t = 1 + tan2_x + tan2_y;
    return 1 / (kPiDouble * g.alpha_x * g.alpha_y * h.z * h.z * h.z * h.z * t * t);
}

/// Smith's Lambda (Heitz 2014, eq. 72).
double textbook_lambda(const Ggx& g, const Vec3d& w) {
    const double x = g.alpha_x * w.x / w.z;
    const double y = g.alpha_y * w.y / w.z;
    return (std::sqrt(1 + x * x + y * y) - 1) / 2;
}

/// The integral over the hemisphere of density(h), by a rule fine near the pole.
double integral(const std::function<double(const Vec3&)>& density) {
    constexpr int kPolar = 4000;
    constexpr int kAround = 120;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double t = (i + 0.5) / kPolar;
        const double polar = t * t * kPiDouble / 2;
        const double step = t * kPiDouble / kPolar;
        for (int j = 0; j < kAround; ++j) {
            const double angle = (j + 0.5) * 2 * kPiDouble / kAround;
            const Vec3d h(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                          std::cos(polar));
            sum += density(Vec3(h)) * std::sin(polar) * step * 2 * kPiDouble / kAround;
        }
    }
    return sum;
}

TEST(Ggx, formulas_are_the_textbook) {
    RandomStream stream(4, Purpose::test, 0, 0);
    for (const Ggx& g : kFacets)
        for (int i = 0; i < 500; ++i) {
            const Vec3 a = laws::random_direction(stream);
            const Vec3 b = laws::random_direction(stream);
            const double lambda_a = textbook_lambda(g, Vec3d(a));
            const double lambda_b = textbook_lambda(g, Vec3d(b));
            const double d = textbook_density(g, Vec3d(b));
            const double zz = std::abs(double{a.z} * b.z);
            EXPECT_NEAR(g.density(b) / d, 1, 1e-5);
            EXPECT_NEAR(g.shadowing_over_cosines(a, b) * zz * (1 + lambda_a + lambda_b), 1, 1e-5);
            EXPECT_NEAR(g.shadowing_given_masking(a, b) * (1 + lambda_a + lambda_b), 1 + lambda_a,
                        1e-5 * (1 + lambda_a));
            EXPECT_NEAR(g.visible_density_over_cosine(a, b) * (1 + lambda_a) * std::abs(a.z) / d, 1,
                        1e-5);
        }
}

TEST(Ggx, projected_area_is_one) {
    for (const Ggx& g : kFacets)
        EXPECT_NEAR(integral([&](const Vec3& h) { return double{g.density(h)} * h.z; }), 1, 1e-3);
}

/// Smith's masking is the one that keeps the projected area of what is seen.
TEST(Ggx, visible_normals_are_a_density) {
    for (const Ggx& g : kFacets)
        for (const Vec3& w :
             {laws::direction_at(1, 0), laws::direction_at(0.4F, 1), laws::direction_at(0.05F, 2)})
            EXPECT_NEAR(integral([&](const Vec3& h) {
                            return double{g.visible_density_over_cosine(w, h)} *
                                   std::max(0.0F, w.dot(h));
                        }),
                        1, 2e-3);
}

/// The mean of 2^16 normals that w sees.
Vec3d mean_sample(const Ggx& g, const Vec3& w) {
    constexpr int kSamples = 1 << 16;
    RandomStream stream(5, Purpose::test, 0, 0);
    Vec3d mean(0);
    for (int i = 0; i < kSamples; ++i) {
        const float u = stream.next_float();
        const Vec3 h = g.sample_visible(w, u, stream.next_float());
        EXPECT_NEAR(h.length(), 1, 1e-6F);
        EXPECT_GE(h.z, 0);
        mean += Vec3d(h) / kSamples;
    }
    return mean;
}

/// Five standard errors are at most 5 * 0.5 / 256: a mean that is off by 0.01 is seen. The whole
/// distribution is tested with each BSDF's pdf (tests/laws/bsdf_sampling_laws_test.cpp).
void expect_visible_samples(const Ggx& g, const Vec3& w) {
    const auto truth = [&](int axis) {
        return integral([&](const Vec3& h) {
            return double{g.visible_density_over_cosine(w, h)} * std::max(0.0F, w.dot(h)) * h[axis];
        });
    };
    const Vec3d mean = mean_sample(g, w);
    EXPECT_NEAR(mean.x, truth(0), 0.01) << w;
    EXPECT_NEAR(mean.y, truth(1), 0.01) << w;
    EXPECT_NEAR(mean.z, truth(2), 0.01) << w;
}

TEST(Ggx, samples_are_the_visible_normals) {
    for (const Ggx& g : kFacets) {
        expect_visible_samples(g, laws::direction_at(1, 0));
        expect_visible_samples(g, laws::direction_at(0.4F, 1));
        expect_visible_samples(g, laws::direction_at(0.05F, 2));
    }
}

TEST(Ggx, grazing_is_finite) {
    const Ggx g{0.3F, 0.1F};
    const Vec3 flat(1, 0, 0);
    const Vec3 h = laws::direction_at(0.3F, 0);
    EXPECT_TRUE(std::isfinite(g.visible_density_over_cosine(flat, h)));
    EXPECT_TRUE(std::isfinite(g.shadowing_over_cosines(flat, h)));
    EXPECT_EQ(g.shadowing_given_masking(h, flat), 0);
}

}  // namespace
}  // namespace sunfleck::engine
