// Metrics: the error of a picture against its reference; docs/guide/compare.md has the formulas.
#pragma once

#include "compare/rgb_image.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Missing values are NaN. Means are over pixels that are finite in both pictures, and over R, G
/// and B.
struct Metrics {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    double mse = kNone;
    double rel_mse = kNone;
    double smape = kNone;
    double flip = kNone;
    double hdr_flip = kNone;         // missing for a black reference, or if not requested
    double luminance_ratio = kNone;  // missing for a black reference
};

/// One row per metric: in tables, in JSON and on the page.
struct MetricRow {
    std::string_view name;   // in JSON
    std::string_view title;  // in tables
    double Metrics::*value;
    double best;  // value for equal pictures
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
    std::size_t left_out = 0;     // pixels that are not finite in one of both
    std::vector<float> flip_map;  // LDR-FLIP per pixel in [0,1]; zero where left out
};

/// Added to the denominators of relMSE and SMAPE, so that dark pixels count less.
inline constexpr double kEpsilon = 0.01;

/// @param test  has the size of the reference. @param with_hdr  also computes HDR-FLIP, the
/// slowest.
Measured measure(const RgbImage& reference, const RgbImage& test, bool with_hdr = true);

}  // namespace sunfleck::engine
