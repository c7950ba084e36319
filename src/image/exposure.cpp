// Mean of logarithms.
#include "image/exposure.h"

#include "image/output_transform.h"
#include "math/colour.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sunfleck::engine {

namespace {

/// Returns the luminance of the pixels that have light and are finite.
std::vector<double> lit_pixels(const Picture& picture) {
    std::vector<double> lit;
    const Channel* const red = picture.find("R");
    const Channel* const green = picture.find("G");
    const Channel* const blue = picture.find("B");
    if (red == nullptr || green == nullptr || blue == nullptr) return lit;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        const double luminance = kLuminanceWeights[0] * red->values[i] +
                                 kLuminanceWeights[1] * green->values[i] +
                                 kLuminanceWeights[2] * blue->values[i];
        if (luminance > 0 && std::isfinite(luminance)) lit.push_back(luminance);
    }
    return lit;
}

}  // namespace

double automatic_stops(const Picture& picture) {
    constexpr double kMiddleGrey = 0.18;
    constexpr double kDark = 0.01;  // over the mean: less is as good as black
    const std::vector<double> lit = lit_pixels(picture);
    if (lit.empty()) return 0;
    const auto count = static_cast<double>(lit.size());
    const double mean = std::accumulate(lit.begin(), lit.end(), 0.0) / count;
    double sum = 0;
    double counted = 0;
    for (const double luminance : lit) {
        if (luminance < kDark * mean) continue;
        sum += std::log2(luminance);
        ++counted;
    }
    const double stops = std::log2(kMiddleGrey) - sum / counted;
    return std::clamp(std::round(stops * 10) / 10, -kMostExposure, kMostExposure);
}

}  // namespace sunfleck::engine
