// Free paths: what flies through a medium is what Beer's law says, colour by colour.
#include "medium/free_path.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

SampledSpectrum ramp(float first, float last) {
    SampledSpectrum s;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        s[i] = first + (last - first) * static_cast<float>(i) / (kWavelengths - 1);
    return s;
}

SampledMedium medium_of(const SampledSpectrum& absorption, const SampledSpectrum& scattering) {
    return {absorption, scattering, {}, true};
}

Ray way(float length) {
    return {Vec3(0), Vec3(1, 0, 0), length};
}

struct Example {
    const char* name;
    SampledMedium medium;
    SampledSpectrum carried;
    float length;
};

std::vector<Example> examples() {
    SampledSpectrum red;
    red[6] = 2;
    SampledSpectrum no_blue = ramp(0, 1.4F);
    return {
        {"grey", medium_of(SampledSpectrum(0.1F), SampledSpectrum(0.7F)), SampledSpectrum(1), 2},
        {"coloured", medium_of(ramp(0.3F, 0), ramp(0.01F, 3)), ramp(0.2F, 1), 1.5F},
        {"thin", medium_of(ramp(0, 1e-6F), ramp(1e-6F, 4e-6F)), SampledSpectrum(1), 1},
        {"thick", medium_of(SampledSpectrum(), ramp(20, 60)), ramp(1, 3), 1},
        {"without_end", medium_of(ramp(0, 0.1F), ramp(0.3F, 0.9F)), SampledSpectrum(1), kInfinity},
        {"half_clear", medium_of(SampledSpectrum(), no_blue), ramp(1, 2), kInfinity},
        {"of_one_wavelength", medium_of(ramp(0, 1), ramp(0.5F, 2)), red, 1},
        {"dark", medium_of(SampledSpectrum(), ramp(0.5F, 2)), SampledSpectrum(), 1},
    };
}

class FreePaths : public testing::TestWithParam<Example> {
protected:
    const SampledMedium& medium() const { return GetParam().medium; }
    float length() const { return GetParam().length; }
};

/// The mean over even numbers u is the integral: what is scattered, s / (s + a) (1 - T), and what
/// passes, T.
TEST_P(FreePaths, bring_what_beers_law_says) {
    constexpr int kNumbers = 100'000;
    std::array<double, kWavelengths> scattered{};
    std::array<double, kWavelengths> passed{};
    for (int i = 0; i < kNumbers; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) / kNumbers;
        const Flight flight = fly(medium(), way(length()), GetParam().carried, u);
        auto& sums = flight.is_scattered ? scattered : passed;
        for (std::size_t w = 0; w < kWavelengths; ++w)
            sums.at(w) += static_cast<double>(flight.weight[w]) / kNumbers;
    }
    for (std::size_t w = 0; w < kWavelengths; ++w) {
        if (GetParam().carried.sum() > 0 && !(GetParam().carried[w] > 0)) continue;
        const double s = static_cast<double>(medium().scattering[w]);
        const double all = s + static_cast<double>(medium().absorption[w]);
        const double left = all > 0 ? std::exp(-all * static_cast<double>(length())) : 1;
        const double sent = all > 0 ? s / all * (1 - left) : 0;
        EXPECT_NEAR(passed.at(w), left, 1e-4 + 1e-3 * left) << w;
        EXPECT_NEAR(scattered.at(w), sent, 2e-5 + 2e-3 * sent) << w;
    }
}

/// But for absorption the sum over wavelengths stays: no medium makes flashes.
TEST_P(FreePaths, keep_the_sum_of_all_light) {
    SampledMedium clear = medium();
    clear.absorption = SampledSpectrum();
    const SampledSpectrum carried =
        GetParam().carried.sum() > 0 ? GetParam().carried : SampledSpectrum(1);
    for (int i = 0; i < 1000; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) / 1000;
        const SampledSpectrum left = carried * fly(clear, way(length()), carried, u).weight;
        EXPECT_NEAR(left.sum() / carried.sum(), 1, 1e-4) << u;
    }
}

TEST_P(FreePaths, distances_invert_chances) {
    const FreePath path(medium(), GetParam().carried);
    const float most = path.chance(length());
    for (int i = 0; i < 1000; ++i) {
        const float chance = most * (static_cast<float>(i) + 0.5F) / 1000;
        EXPECT_NEAR(path.chance(path.distance_at(chance)) / chance, 1, 1e-5) << chance;
    }
}

TEST_P(FreePaths, density_is_the_slope_of_chance) {
    const FreePath path(medium(), GetParam().carried);
    const float end = std::min(length(), 2.0F);
    for (int i = 0; i < 16; ++i) {
        const float from = end * static_cast<float>(i) / 16;
        const float step = end / 16000;
        EXPECT_NEAR(path.chance_between(from, from + step) / step / path.density(from + step / 2),
                    1, 1e-3)
            << from;
    }
}

/// Chances of parts add up, with as many digits where they are small.
TEST_P(FreePaths, chances_of_parts_add_up) {
    const FreePath path(medium(), GetParam().carried);
    const float end = std::min(length(), 4.0F);
    float sum = 0;
    for (int i = 0; i < 8; ++i)
        sum += path.chance_between(end * static_cast<float>(i) / 8,
                                   end * static_cast<float>(i + 1) / 8);
    EXPECT_NEAR(sum / path.chance(end), 1, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, FreePaths, testing::ValuesIn(examples()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Transmittance, is_beers_law) {
    SampledSpectrum sigma(0.7F);
    sigma[0] = 0;
    const SampledMedium medium = medium_of(sigma, SampledSpectrum());
    EXPECT_FLOAT_EQ(transmittance(medium, way(2))[1], std::exp(-1.4F));
    EXPECT_EQ(transmittance(medium, way(2))[0], 1);
    EXPECT_EQ(transmittance(medium, way(kInfinity))[0], 1);
    EXPECT_EQ(transmittance(medium, way(kInfinity))[1], 0);
    const SampledMedium cloudy = medium_of(sigma, SampledSpectrum(0.2F));
    EXPECT_FLOAT_EQ(transmittance(cloudy, way(2))[1], std::exp(-1.8F));
}

}  // namespace
}  // namespace sunfleck::engine
