// The metrics, pixel by pixel in one fixed order.
#include "compare/metrics.h"

#include "compare/flip.h"

namespace sunfleck::engine {
namespace {

/// Both pictures, with zero in place of what is not finite in one of them.
struct Pair {
    RgbImage reference;
    RgbImage test;
    std::vector<bool> counts;  // is finite in both
    std::size_t counted = 0;
};

Pair finite_pair(const RgbImage& reference, const RgbImage& test) {
    Pair pair{reference, test, std::vector<bool>(reference.pixels.size()), 0};
    for (std::size_t i = 0; i < pair.counts.size(); ++i) {
        pair.counts[i] = is_finite(reference.pixels[i]) && is_finite(test.pixels[i]);
        if (pair.counts[i])
            ++pair.counted;
        else
            pair.reference.pixels[i] = pair.test.pixels[i] = Vec3(0);
    }
    return pair;
}

/// What is left out is zero, and adds nothing.
double mean_of(const std::vector<float>& map, std::size_t counted) {
    if (map.empty()) return Metrics::kNone;
    double sum = 0;
    for (const float value : map) sum += static_cast<double>(value);
    return sum / static_cast<double>(counted);
}

void add_sums(const Pair& pair, Metrics& metrics) {
    double square = 0;
    double relative = 0;
    double symmetric = 0;
    double light = 0;
    double reference_light = 0;
    for (std::size_t i = 0; i < pair.counts.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto a = static_cast<double>(pair.test.pixels[i][c]);
            const auto r = static_cast<double>(pair.reference.pixels[i][c]);
            const double difference = a - r;
            square += difference * difference;
            relative += difference * difference / (r * r + kEpsilon);
            symmetric += std::abs(difference) / (std::abs(a) + std::abs(r) + kEpsilon);
        }
        light += static_cast<double>(luminance(pair.test.pixels[i]));
        reference_light += static_cast<double>(luminance(pair.reference.pixels[i]));
    }
    const double values = 3 * static_cast<double>(pair.counted);
    metrics.mse = square / values;
    metrics.rel_mse = relative / values;
    metrics.smape = symmetric / values;
    if (reference_light > 0) metrics.luminance_ratio = light / reference_light;
}

}  // namespace

Measured measure(const RgbImage& reference, const RgbImage& test, bool with_hdr) {
    const Pair pair = finite_pair(reference, test);
    Measured result;
    result.left_out = pair.counts.size() - pair.counted;
    if (pair.counted == 0) {
        result.flip_map.resize(pair.counts.size());
        return result;
    }
    add_sums(pair, result.metrics);
    result.flip_map = ldr_flip(pair.reference, pair.test);
    // Filters bring their neighbours' light to pixels that are left out.
    const auto leave_out = [&](std::vector<float>& map) {
        for (std::size_t i = 0; i < map.size(); ++i)
            if (!pair.counts[i]) map[i] = 0;
    };
    leave_out(result.flip_map);
    result.metrics.flip = mean_of(result.flip_map, pair.counted);
    if (!with_hdr) return result;
    std::vector<float> hdr = hdr_flip(pair.reference, pair.test);
    leave_out(hdr);
    result.metrics.hdr_flip = mean_of(hdr, pair.counted);
    return result;
}

}  // namespace sunfleck::engine
