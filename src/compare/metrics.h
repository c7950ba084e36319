// How far a picture is from its reference, in numbers: docs/guide/compare.md has the formulas.
#pragma once

#include "compare/rgb_image.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// What has no value is NaN. Means are over pixels that are finite in both pictures, and over R, G
/// and B.
struct Metrics {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    double mse = kNone;
    double rel_mse = kNone;
    double smape = kNone;
    double flip = kNone;
    double hdr_flip = kNone;         // also none of a black reference, or when not asked for
    double luminance_ratio = kNone;  // also none of a black reference
};

/// One row a metric: in tables, in JSON and on the page.
struct MetricRow {
    std::string_view name;   // in JSON
    std::string_view title;  // in tables
    double Metrics::*value;
    double best;  // what equal pictures give
};
inline constexpr std::array kMetrics = {
    MetricRow{"mse", "MSE", &Metrics::mse, 0},
    MetricRow{"rel_mse", "relMSE", &Metrics::rel_mse, 0},
    MetricRow{"smape", "SMAPE", &Metrics::smape, 0},
    MetricRow{"flip", "FLIP", &Metrics::flip, 0},
    MetricRow{"hdr_flip", "HDR-FLIP", &Metrics::hdr_flip, 0},
    MetricRow{"luminance_ratio", "luminance ratio", &Metrics::luminance_ratio, 1},
};

struct Measured {
    Metrics metrics;
    std::size_t left_out = 0;     // pixels that are not finite in one of the two
    std::vector<float> flip_map;  // of LDR-FLIP, each pixel in [0,1]; zero where left out
};

/// What keeps the denominators of relMSE and SMAPE off zero: dark pixels count less.
inline constexpr double kEpsilon = 0.01;

/// @param test  of the reference's size. @param with_hdr  computes HDR-FLIP, the slowest, too.
Measured measure(const RgbImage& reference, const RgbImage& test, bool with_hdr = true);

}  // namespace sunfleck::engine
