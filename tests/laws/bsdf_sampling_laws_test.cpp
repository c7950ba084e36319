// Laws of the BSDFs that spread light: samples fall as the pdf says; the pdf's and f's integrals.
//
// Chi-square of 2^18 samples in 20 x 12 bins of the sphere and one for "absorbed", seed 2,
// significance 1e-4 a test. Smallest effect: a pdf that is 2% too large is seen in every example.
#include "laws/bsdf_examples.h"
#include "laws/significance.h"
#include "math/statistics.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <sstream>

namespace sunfleck::engine::laws {
namespace {

constexpr std::size_t kSamples = 1U << 18U;
constexpr std::size_t kRows = 20;     // of equal cosine steps
constexpr std::size_t kColumns = 12;  // of equal azimuth steps

std::size_t bin_of(const Vec3& w) {
    const double turn = std::atan2(w.y, w.x) / (2 * kPiDouble);
    const auto row = static_cast<std::size_t>((w.z + 1) / 2 * kRows);
    const auto column = static_cast<std::size_t>((turn - std::floor(turn)) * kColumns);
    return std::min(row, kRows - 1) * kColumns + std::min(column, kColumns - 1);
}

/// The integral of `density` over each bin: in the polar angle by Gauss's rule of two points, in
/// azimuth by the midpoint rule, `fine`^2 points a bin. @param fine  even.
std::vector<double> integrals(std::size_t fine, const std::function<float(const Vec3&)>& density) {
    std::vector<double> sums(kRows * kColumns, 0);
    const std::size_t columns = kColumns * fine;
    const double column_step = 2 * kPiDouble / static_cast<double>(columns);
    for (std::size_t r = 0; r < kRows * fine; ++r) {
        const std::size_t coarse = r / fine;
        const auto row = static_cast<double>(coarse);
        const double low = std::acos(2 * (row + 1) / kRows - 1);
        const double row_step = (std::acos(2 * row / kRows - 1) - low) / static_cast<double>(fine);
        // Of each pair of steps the points lie at 1 -+ 1 / sqrt(3), not at 0.5 and 1.5.
        const double gauss = r % 2 == 0 ? 1 - std::sqrt(1.0 / 3) : std::sqrt(1.0 / 3);
        const double polar = low + (static_cast<double>(r % fine) + gauss) * row_step;
        const double flat = std::sin(polar);
        for (std::size_t c = 0; c < columns; ++c) {
            const double angle = (static_cast<double>(c) + 0.5) * column_step;
            const Vec3 w(Vec3d(flat * std::cos(angle), flat * std::sin(angle), std::cos(polar)));
            sums[coarse * kColumns + c / fine] += density(w) * flat * row_step * column_step;
        }
    }
    return sums;
}

double total(const std::vector<double>& terms) {
    double sum = 0;
    for (const double t : terms) sum += t;
    return sum;
}

/// Bins of fewer than 20 expected samples are taken together.
double chi_square(const std::vector<double>& counts, const std::vector<double>& expected) {
    double statistic = 0;
    double rest_count = 0;
    double rest_expected = 0;
    int bins = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 20) {
            rest_count += counts[i];
            rest_expected += expected[i];
            continue;
        }
        statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        ++bins;
    }
    if (rest_expected > 1) {
        statistic += (rest_count - rest_expected) * (rest_count - rest_expected) / rest_expected;
        ++bins;
    } else {
        EXPECT_LE(rest_count, 10);
    }
    return bins > 1 ? testing_support::chi_square_p(statistic, bins - 1) : 1;
}

class BsdfSamplingLaws : public testing::TestWithParam<BsdfExample> {
protected:
    const Bsdf& bsdf() const { return bsdf_; }

    RunningMean mean_weight(const Vec3& wo, std::size_t wavelength) {
        RunningMean mean;
        for (std::size_t i = 0; i < kSamples / 4; ++i) {
            const auto drawn = sample(bsdf(), wo, subpass_number(i, kSamples / 4, stream_));
            mean.add(drawn && drawn->pdf ? drawn->weight[wavelength] : 0);
        }
        return mean;
    }

    const Bsdf bsdf_ = GetParam().make();
    RandomStream stream_{2, Purpose::test, 0, 0};
};

std::vector<Vec3> few_directions() {
    return {direction_at(1, 0), direction_at(0.35F, 2.5F), direction_at(-0.8F, 4.0F),
            direction_at(-0.2F, 3.0F)};
}

/// Delta samples of a coat count with those that are absorbed.
TEST_P(BsdfSamplingLaws, samples_are_spread_as_the_pdf_says) {
    for (const Vec3& wo : few_directions()) {
        std::vector<double> expected =
            integrals(32, [&](const Vec3& w) { return pdf(bsdf(), wo, w, Transport::flux); });
        const double kept = total(expected);
        EXPECT_LE(kept, 1 + 1e-3) << wo;
        expected.push_back(std::max(0.0, 1 - kept));
        for (double& e : expected) e *= static_cast<double>(kSamples);

        std::vector<double> counts(expected.size(), 0);
        for (std::size_t i = 0; i < kSamples; ++i) {
            BsdfSampleInput draw{{}, Transport::flux, {i % kWavelengths, false}};
            draw.u = {stream_.next_float(), stream_.next_float(), stream_.next_float()};
            const auto drawn = sample(bsdf(), wo, draw);
            ++counts[drawn && drawn->pdf ? bin_of(drawn->wi) : kRows * kColumns];
        }
        EXPECT_GT(chi_square(counts, expected), kSignificance) << wo;
    }
}

/// The mean weight is the integral of f |cos|; what it lacks to one is printed as the loss. Four
/// standard errors and 1e-3 for the quadrature.
TEST_P(BsdfSamplingLaws, mean_weight_is_the_integral_of_eval) {
    std::ostringstream losses;
    for (const Vec3& wo : few_directions())
        for (const std::size_t wavelength : {std::size_t{0}, kWavelengths - 1}) {
            const double albedo = total(integrals(40, [&](const Vec3& w) {
                return eval(bsdf(), wo, w, Transport::flux)[wavelength] * cosine_of(bsdf(), w);
            }));
            EXPECT_LE(albedo, 1 + 1e-3);
            losses << ' ' << 1 - albedo;
            const RunningMean mean = mean_weight(wo, wavelength);
            EXPECT_NEAR(mean.mean(), albedo, 4 * mean.standard_error() + 1e-3)
                << wo << " wavelength " << wavelength;
        }
    std::cout << "loss, first and last wavelength, per direction:" << losses.str() << "\n";
}

INSTANTIATE_TEST_SUITE_P(All, BsdfSamplingLaws, testing::ValuesIn(spread_examples()),
                         [](const auto& info) { return name_of(info); });

}  // namespace
}  // namespace sunfleck::engine::laws
