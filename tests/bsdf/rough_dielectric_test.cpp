// Rough glass: smooth glass is its limit, its wavelengths are one-index glasses side by side.
#include "bsdf/rough_dielectric.h"

#include "bsdf/smooth_dielectric.h"
#include "laws/bsdf_examples.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Draws in which rough and smooth glass part.
struct Parting {
    int elsewhere = 0;  // the lobe's number fell between two shares
    int tail = 0;       // a facet that is tilted much
};

Parting compare_with_smooth(const RoughDielectric& rough, const Vec3& w, Transport transport) {
    const SmoothDielectric smooth(rough.eta());
    RandomStream stream(7, Purpose::test, 0, 0);
    Parting parting;
    for (int i = 0; i < 2000; ++i) {
        const float lobe = stream.next_float();
        const float u = stream.next_float();
        const BsdfSampleInput draw{Vec3(lobe, u, stream.next_float()), transport, {}};
        const BsdfSample r = rough.sample(w, draw).value();
        const BsdfSample s = smooth.sample(w, draw).value();
        if (r.wi.z * s.wi.z < 0) {
            ++parting.elsewhere;
        } else if ((r.wi - s.wi).length() > 0.03F) {
            ++parting.tail;
        } else {
            EXPECT_NEAR(r.weight[3], s.weight[3], 2e-3F * s.weight[3]);
            EXPECT_EQ(r.eta, s.eta);
        }
    }
    return parting;
}

/// Facets of alpha 1e-3 tilt by some 1e-3 (by t or more with probability 1e-6 / t^2): direction,
/// weight and share approach the smooth ones, but for a tail.
TEST(RoughDielectric, smooth_glass_is_the_limit) {
    const RoughDielectric rough(SampledSpectrum(1.5F), {1e-3F, 1e-3F});
    for (const Vec3& w : {laws::direction_at(1, 0), laws::direction_at(0.6F, 2),
                          laws::direction_at(-0.9F, 1), laws::direction_at(-0.5F, 1)})
        for (const Transport transport : {Transport::radiance, Transport::flux}) {
            const Parting parting = compare_with_smooth(rough, w, transport);
            EXPECT_LE(parting.elsewhere, 5);
            EXPECT_LE(parting.tail, 40);
        }
}

void expect_wavelengths_apart(const RoughDielectric& prism, const Vec3& a, const Vec3& b,
                              Transport t) {
    const SampledSpectrum f = prism.eval(a, b, t);
    float mean_pdf = 0;
    for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
        const RoughDielectric one = prism.at_wavelength(wavelength);
        EXPECT_EQ(f[wavelength], one.eval(a, b, t)[wavelength]);
        mean_pdf += one.pdf(a, b, t) / kWavelengths;
    }
    EXPECT_NEAR(prism.pdf(a, b, t), mean_pdf, 1e-5F * mean_pdf);
}

TEST(RoughDielectric, wavelengths_see_glasses_of_one_index) {
    const RoughDielectric prism(laws::ramp(1.7F, 1.5F), {0.3F, 0.2F});
    ASSERT_TRUE(prism.is_dispersive());
    EXPECT_FALSE(prism.at_wavelength(3).is_dispersive());
    RandomStream stream(8, Purpose::test, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = laws::random_direction(stream);
        const Vec3 b = laws::random_direction(stream);
        expect_wavelengths_apart(prism, a, b, Transport::radiance);
        expect_wavelengths_apart(prism, a, b, Transport::flux);
    }
}

/// Walter et al. 2007, eq. 20 and 21, written out in double for one pair of directions each.
TEST(RoughDielectric, values_are_walters) {
    const double alpha = 0.4;
    const double eta = 1.5;
    const RoughDielectric glass(SampledSpectrum(1.5F), {0.4F, 0.4F});
    const Vec3d i(0.6, 0, 0.8);
    const Vec3d o = Vec3d(-0.2, 0.1, -0.7).normalized();
    const Vec3d h = (i + o * eta).normalized() * -1.0;  // h.z > 0 as eta > 1 and o is below
    ASSERT_GT(h.z, 0);
    const double ih = i.dot(h);
    const double oh = o.dot(h);
    const auto lambda = [&](const Vec3d& w) {
        return (std::sqrt(1 + alpha * alpha * (1 / (w.z * w.z) - 1)) - 1) / 2;
    };
    const double g = 1 / (1 + lambda(i) + lambda(o));
    const double tan2 = 1 / (h.z * h.z) - 1;
    const double d =
        alpha * alpha /
        (kPiDouble * std::pow(h.z, 4) * (alpha * alpha + tan2) * (alpha * alpha + tan2));
    const double c = ih;
    const double gg = std::sqrt(eta * eta - 1 + c * c);  // eq. 22
    const double parallel = (c * (gg + c) - 1) / (c * (gg - c) + 1);
    const double f = 0.5 * std::pow((gg - c) / (gg + c), 2) * (1 + parallel * parallel);
    const double btdf = std::abs(ih * oh / (i.z * o.z)) * eta * eta * (1 - f) * g * d /
                        ((ih + eta * oh) * (ih + eta * oh));
    // Light comes from outside along i and leaves inside along o.
    const SampledSpectrum value = glass.eval(Vec3(i), Vec3(o), Transport::flux);
    EXPECT_NEAR(value[0] / btdf, 1, 1e-5);
    EXPECT_EQ(value, SampledSpectrum(value[0]));
    EXPECT_NEAR(glass.eval(Vec3(i), Vec3(o), Transport::radiance)[0] * eta * eta / btdf, 1, 1e-5);
}

}  // namespace
}  // namespace sunfleck::engine
