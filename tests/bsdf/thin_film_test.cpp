// Interference in thin films, against the sum over all ways of light in complex numbers.
#include "bsdf/thin_film.h"

#include "laws/bsdf_examples.h"
#include "laws/bsdf_fresnel.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using Complex = std::complex<double>;

/// Adds echo after echo, for one polarisation. @param r, s  amplitudes of the upper face from
/// above, and of the lower one.
double echoes(Complex r, Complex s, double phase) {
    const Complex turn = std::polar(1.0, phase);
    Complex sum = r;
    Complex within = (1.0 - r * r) * s * turn;  // Stokes: what passes both ways, 1 - r^2
    for (int echo = 0; echo < 2000; ++echo, within *= -r * s * turn) sum += within;
    return std::norm(sum);
}

double truth(double cosine, double film, double waves, Complex metal) {
    const Complex in_film = std::sqrt(1.0 - (1 - cosine * cosine) / (film * film));
    const Complex in_metal = std::sqrt(1.0 - (1 - cosine * cosine) / (metal * metal));
    const auto across = [](Complex n, Complex c, Complex m, Complex d) {
        return (n * c - m * d) / (n * c + m * d);
    };
    const double phase = 4 * std::acos(-1.0) * waves * film * in_film.real();
    const double s =
        echoes(across(1, cosine, film, in_film), across(film, in_film, metal, in_metal), phase);
    const double p =
        echoes(across(film, cosine, 1, in_film), across(metal, in_film, film, in_metal), phase);
    return (s + p) / 2;
}

TEST(ThinFilm, reflectance_is_the_sum_of_all_echoes) {
    const SampledSpectrum eta = laws::gold_eta();
    const SampledSpectrum k = laws::gold_k();
    const ThinFilm film{1.8F, laws::ramp(0.3F, 2.1F)};
    for (const float cosine : {1.0F, 0.7F, 0.3F, 0.05F}) {
        const SampledSpectrum reflectance = film_reflectance(cosine, film, eta, k);
        for (std::size_t i = 0; i < kWavelengths; ++i)
            EXPECT_NEAR(reflectance[i], truth(cosine, film.eta, film.waves[i], {eta[i], k[i]}),
                        2e-5)
                << cosine << ' ' << i;
    }
}

/// A film of no thickness, and one of no contrast, are none.
TEST(ThinFilm, that_is_nothing_leaves_the_metal) {
    const SampledSpectrum eta = laws::gold_eta();
    const SampledSpectrum k = laws::gold_k();
    for (const ThinFilm& film : {ThinFilm{1.8F, {}}, ThinFilm{1, SampledSpectrum(0.7F)}})
        for (const float cosine : {1.0F, 0.4F}) {
            const SampledSpectrum bare = conductor_reflectance(cosine, eta, k);
            const SampledSpectrum with = film_reflectance(cosine, film, eta, k);
            for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(with[i], bare[i], 2e-6);
        }
}

/// A quarter of a wave of index sqrt(n) over a plain dielectric reflects nothing.
TEST(ThinFilm, a_quarter_wave_cancels) {
    const ThinFilm film{1.5F, SampledSpectrum(0.25F / 1.5F)};
    EXPECT_NEAR(film_reflectance(1, film, SampledSpectrum(2.25F), {})[0], 0, 1e-7);
}

}  // namespace
}  // namespace sunfleck::engine
