// Mean of logarithms.
#include "image/exposure.h"

#include "image/picture_file.h"
#include "math/colour.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

double automatic_stops(const Picture& picture) {
    constexpr double kMiddleGrey = 0.18;
    double sum = 0;
    std::size_t count = 0;
    const Channel* const red = picture.find("R");
    const Channel* const green = picture.find("G");
    const Channel* const blue = picture.find("B");
    if (red == nullptr || green == nullptr || blue == nullptr) return 0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        const double luminance = kLuminanceWeights[0] * red->values[i] +
                                 kLuminanceWeights[1] * green->values[i] +
                                 kLuminanceWeights[2] * blue->values[i];
        if (!(luminance > 0) || !std::isfinite(luminance)) continue;
        sum += std::log2(luminance);
        ++count;
    }
    if (count == 0) return 0;
    const double stops = std::log2(kMiddleGrey) - sum / static_cast<double>(count);
    return std::clamp(std::round(stops * 10) / 10, -kMostExposure, kMostExposure);
}

}  // namespace sunfleck::engine
