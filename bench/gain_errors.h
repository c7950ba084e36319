// Errors of renders against a reference, and ratios of error times processor time with intervals.
#pragma once

#include "bootstrap.h"
#include "compare/relative_square.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace sunfleck::engine::bench {

inline double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// Means over pixels: relative squares, and squares over the picture's mean.
struct Error {
    double relative = 0;
    double plain = 0;
};

/// @param expected  what the image is compared with. @param reference  what relative squares are
/// relative to: one for all samplers, or spikes of a sampler would excuse themselves.
inline Error error_of(const std::vector<double>& image, const std::vector<double>& expected,
                      const std::vector<double>& reference) {
    const double mean = mean_of(reference);
    Error error;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double square = (image[i] - expected[i]) * (image[i] - expected[i]);
        error.relative += relative_square(square, reference[i], mean);
        error.plain += square / (mean * mean);
    }
    error.relative /= static_cast<double>(image.size());
    error.plain /= static_cast<double>(image.size());
    return error;
}

struct Sample {
    Error error;
    double seconds;
    double brightness;
    std::vector<double> image;
};

inline std::vector<double> mean_image(const std::vector<Sample>& samples) {
    std::vector<double> mean(samples.front().image.size());
    for (const Sample& s : samples)
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += s.image[i] / static_cast<double>(samples.size());
    return mean;
}

/// Errors of the samples around their mean, corrected for what the mean shares with each.
inline void measure_by_own_mean(std::vector<Sample>& samples,
                                const std::vector<double>& reference) {
    const std::vector<double> mean = mean_image(samples);
    const auto count = static_cast<double>(samples.size());
    for (Sample& s : samples) {
        s.error = error_of(s.image, mean, reference);
        s.error.relative *= count / (count - 1);
        s.error.plain *= count / (count - 1);
    }
}

/// Errors of the samples against a reference, corrected for its own. @param own  squared error of
/// the reference.
inline void measure_by(std::vector<Sample>& samples, const std::vector<double>& reference,
                       const Error& own) {
    for (Sample& s : samples) {
        s.error = error_of(s.image, reference, reference);
        s.error.relative -= own.relative;
        s.error.plain -= own.plain;
    }
}

/// The error of the mean of renders, from their spread. @param mean  theirs.
inline Error error_of_mean(const std::vector<Sample>& renders, const std::vector<double>& mean) {
    const auto count = static_cast<double>(renders.size());
    Error error;
    for (const Sample& s : renders) {
        const Error around = error_of(s.image, mean, mean);
        error.relative += around.relative / (count * (count - 1));
        error.plain += around.plain / (count * (count - 1));
    }
    return error;
}

using Samples = std::map<std::string, std::vector<Sample>>;

inline double mean_by(const std::vector<Sample>& samples, const std::vector<std::size_t>& which,
                      double Error::*measure) {
    double error = 0;
    double seconds = 0;
    for (const std::size_t i : which) {
        error += samples[i].error.*measure;
        seconds += samples[i].seconds;
    }
    return error / static_cast<double>(which.size()) * seconds;
}

/// The ratio of error times seconds, and its 95% interval by drawing seeds again with repetition.
inline void print_ratio(const std::string& name, const std::vector<Sample>& a,
                        const std::vector<Sample>& b, double Error::*measure) {
    std::vector<std::size_t> all(a.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto ratio = [&](const std::vector<std::size_t>& first,
                           const std::vector<std::size_t>& second) {
        return mean_by(a, first, measure) / mean_by(b, second, measure);
    };
    const Interval interval = bootstrap(a.size(), ratio);
    fmt::print("{:<34} {:10.4g}   [{:.4g}, {:.4g}]\n", name, ratio(all, all), interval.low,
               interval.high);
}

inline void print_ratios(const std::string& names, const std::vector<Sample>& a,
                         const std::vector<Sample>& b) {
    print_ratio(names + ", relMSE x cpu s", a, b, &Error::relative);
    print_ratio(names + ", MSE x cpu s", a, b, &Error::plain);
}

}  // namespace sunfleck::engine::bench
