// What the quick and the slow laws of samplers share.
#pragma once

#include "laws/sampler_examples.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <string>

namespace sunfleck::engine::laws {

/// The mean's interval of that confidence lies within 1 -+ band.
inline void expect_one(const RunningMean& ratio, double confidence, double band,
                       const std::string& what) {
    const double error = ratio.standard_error();
    const double half_width = testing_support::normal_quantile((1 + confidence) / 2) * error;
    EXPECT_GT(half_width, 0) << what;
    EXPECT_LE(std::abs(ratio.mean() - 1) + half_width, band)
        << what << ": bias " << 100 * (ratio.mean() - 1) << "%, interval of +-" << 100 * half_width
        << "%, z = " << (ratio.mean() - 1) / error;
    testing::Test::RecordProperty(
        what, std::to_string(ratio.mean() - 1) + " +- " + std::to_string(half_width));
}

/// Flux and visible fraction have the right means over so many passes. See expect_one().
inline void expect_unbiased(const SamplerExample& example, std::uint64_t seed, std::uint32_t passes,
                            double confidence, double band) {
    const Ratios ratios = run_passes(example, seed, passes);
    expect_one(ratios.flux, confidence, band, "flux");
    expect_one(ratios.visible_fraction, confidence, band, "visible fraction");
}

/// All that a pass gave, in one number.
inline std::uint64_t bytes_of(const PassSums& sums) {
    SummingSink::Collector hash;
    hash.mix(sums.bytes);
    hash.mix(std::bit_cast<std::uint64_t>(sums.flux));
    hash.mix(std::bit_cast<std::uint64_t>(sums.visible_fraction));
    for (const std::uint64_t s : sums.counts.survivors) hash.mix(s);
    for (const LevelCounts& level : sums.counts.levels) {
        hash.mix(level.distinct);
        for (const std::uint64_t h : level.heights) hash.mix(h);
        for (const Acceptance& kind : level.acceptances) hash.mix(kind.accepted);
    }
    return hash.bytes;
}

}  // namespace sunfleck::engine::laws
