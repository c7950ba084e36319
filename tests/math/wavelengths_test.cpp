// The wavelengths of a pass: inside the visible, one lattice a batch, unbiased in colour.
#include "math/wavelengths.h"

#include "math/colour.h"
#include "math/spectrum.h"
#include "math/statistics.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sunfleck::engine {
namespace {

std::array<RunningMean, 3> colours(const Spectrum& curve, std::uint64_t seed, int batches,
                                   std::uint32_t passes) {
    std::array<RunningMean, 3> result;
    for (int batch = 0; batch < batches; ++batch) {
        Vec3 mean(0);
        for (std::uint32_t pass = 0; pass < passes; ++pass) {
            const auto number = static_cast<std::uint32_t>(batch) * kBatchPasses + pass;
            const Wavelengths drawn = Wavelengths::of_pass({seed, number});
            mean += drawn.to_rgb(curve.at(drawn)) / static_cast<float>(passes);
        }
        for (int i = 0; i < 3; ++i) result.at(static_cast<std::size_t>(i)).add(double{mean[i]});
    }
    return result;
}

/// The share of the density below a wavelength, by integration of what the wavelengths report.
double density_below(float nm) {
    std::vector<std::pair<float, float>> drawn;
    for (std::uint32_t pass = 0; pass < 64 * kBatchPasses; ++pass) {
        const Wavelengths w = Wavelengths::of_pass({5, pass});
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
            drawn.emplace_back(w.nm.at(wavelength), w.density.at(wavelength));
    }
    std::sort(drawn.begin(), drawn.end());
    double integral = 0;
    for (std::size_t i = 1; i < drawn.size() && drawn[i].first <= nm; ++i)
        integral += 0.5 * double{drawn[i].second + drawn[i - 1].second} *
                    double{drawn[i].first - drawn[i - 1].first};
    return integral;
}

std::vector<Spectrum> examples() {
    return {Spectrum::d65(),
            Spectrum::constant(1),
            Spectrum::rgb_illuminant(Vec3(1, 0, 0)),
            Spectrum::rgb_illuminant(Vec3(0, 1, 0)),
            Spectrum::rgb_illuminant(Vec3(0, 0, 1)),
            Spectrum::rgb_illuminant(Vec3(0.9F, 0.8F, 0.1F)),
            Spectrum(BlackbodySpectrum{2800}),
            *named_spectrum("stdillum-F2")};
}

TEST(Wavelengths, wavelengths_rise_through_the_visible_and_have_density) {
    for (std::uint32_t pass = 0; pass < 1000; ++pass) {
        const Wavelengths drawn = Wavelengths::of_pass({1, pass});
        EXPECT_TRUE(std::is_sorted(drawn.nm.begin(), drawn.nm.end()));
        EXPECT_GE(drawn.nm.front(), 360);
        EXPECT_LE(drawn.nm.back(), 830);
        for (const float density : drawn.density) EXPECT_GT(density, 5e-5F);
    }
}

TEST(Wavelengths, density_integrates_to_one_and_is_that_of_the_wavelengths) {
    EXPECT_NEAR(density_below(830), 1, 1e-3);
    // Half of the wavelengths lie below the median of the density.
    const Wavelengths drawn = Wavelengths::of_pass({1, 0});
    const double step = density_below(drawn.nm[5]) - density_below(drawn.nm[4]);
    EXPECT_NEAR(step, 0.125, 1e-3);
}

TEST(Wavelengths, weights_are_response_over_density) {
    const Wavelengths drawn = Wavelengths::of_pass({2, 7});
    for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
        const Triple response = rgb_response(double{drawn.nm.at(wavelength)});
        const double scale = 1 / (8 * double{drawn.density.at(wavelength)});
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(drawn.rgb_weight.at(i)[wavelength], response.at(i) * scale, 1e-4);
    }
    const Wavelengths other = Wavelengths::of_pass({2, 8});
    EXPECT_NE(drawn.nm, other.nm);
    EXPECT_EQ(drawn.nm, Wavelengths::of_pass({2, 7}).nm);
}

// The 128 numbers of a batch cut the density in 128 equal parts, and those of 2, 4, 8 passes in
// 16, 32, 64: between neighbours lies the same share of the density.
TEST(Wavelengths, first_passes_and_the_round_are_lattices) {
    for (const std::uint32_t passes : {1U, 2U, 4U, 8U, 16U}) {
        std::vector<std::pair<float, float>> drawn;
        for (std::uint32_t pass = 0; pass < passes; ++pass) {
            const Wavelengths w = Wavelengths::of_pass({3, pass});
            for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
                drawn.emplace_back(w.nm.at(wavelength), w.density.at(wavelength));
        }
        std::sort(drawn.begin(), drawn.end());
        // Trapezoids between neighbours: coarse for few points, so the tolerance falls with them.
        const double part = 1 / static_cast<double>(drawn.size());
        for (std::size_t i = 1; i < drawn.size(); ++i) {
            const double share = 0.5 * double{drawn[i].second + drawn[i - 1].second} *
                                 double{drawn[i].first - drawn[i - 1].first};
            EXPECT_NEAR(share, part, (0.02 + 2 * part) * part) << passes << ' ' << drawn[i].first;
        }
    }
}

TEST(Wavelengths, rounds_are_shifted_apart) {
    std::set<float> first_wavelengths;
    for (std::uint32_t batch = 0; batch < 100; ++batch)
        first_wavelengths.insert(Wavelengths::of_pass({4, batch * kBatchPasses}).nm[0]);
    EXPECT_GT(first_wavelengths.size(), 95U);
    EXPECT_NE(Wavelengths::of_pass({4, 0}).nm, Wavelengths::of_pass({5, 0}).nm);
}

// What one pass and one batch leave of colour error; docs/method/errors.md quotes these figures.
TEST(Wavelengths, white_has_little_error_in_a_pass_and_none_to_see_in_a_batch) {
    const auto pass = colours(Spectrum::d65(), 6, 2000, 1);
    const auto batch = colours(Spectrum::d65(), 6, 200, kBatchPasses);
    const std::array<double, 3> most{0.02, 0.005, 0.02};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::sqrt(pass.at(i).variance()), most.at(i));
        EXPECT_LT(std::sqrt(batch.at(i).variance()), 1e-4);
        EXPECT_NEAR(batch.at(i).mean(), 1, 1e-4);
    }
}

TEST(Wavelengths, a_batch_shows_every_spectrum_in_its_colour) {
    for (const Spectrum& curve : examples()) {
        const Vec3 exact = curve.to_rgb();
        const auto seen = colours(curve, 7, 50, kBatchPasses);
        for (int i = 0; i < 3; ++i) {
            const RunningMean& mean = seen.at(static_cast<std::size_t>(i));
            EXPECT_NEAR(mean.mean(), exact[i], 1e-3 * double{exact.length()});
            EXPECT_LT(std::sqrt(mean.variance()), 4e-3 * double{exact.length()});
        }
    }
}

// Single passes of different batches are independent: a z test of their mean, 8 curves x 3, seed 8,
// significance 0.1% together. With 20000 batches it would see a bias of 0.05% in white, of 0.6% in
// the lines of a fluorescent lamp.
TEST(Wavelengths, single_passes_are_unbiased) {
    for (const Spectrum& curve : examples()) {
        const Vec3 exact = curve.to_rgb();
        const auto seen = colours(curve, 8, 20000, 1);
        for (int i = 0; i < 3; ++i) {
            const RunningMean& mean = seen.at(static_cast<std::size_t>(i));
            const double p =
                testing_support::mean_p(mean.mean(), double{exact[i]}, mean.standard_error());
            EXPECT_GT(p, 0.001 / 24) << mean.mean() << " is not " << exact[i];
            EXPECT_LT(mean.standard_error(), 1.5e-3 * double{exact.length()});
        }
    }
}

}  // namespace
}  // namespace sunfleck::engine
