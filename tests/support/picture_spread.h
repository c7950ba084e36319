// How far the pictures of passes lie from their mean.
#pragma once

#include "support/renders.h"

namespace sunfleck::engine::testing_support {

/// Of pictures, by pixel.
struct PictureSpread {
    double mean = 0;
    double variance = 0;  // of a picture, in the mean over pixels
};

/// Which pictures: each the mean of some consecutive passes.
struct Pictures {
    std::uint32_t first_pass = 0;
    std::uint32_t count = 0;
    std::uint32_t passes = 1;  // of each
};

/// @param epoch  of all passes, whatever their numbers.
inline PictureSpread spread_of(const Scene& scene, const RenderSettings& settings,
                               const Epoch& epoch, const Pictures& pictures, Aov aov = Aov::total) {
    const std::size_t pixels = window_of(scene.film()).pixels();
    std::vector<double> sum(pixels, 0);
    std::vector<double> squares(pixels, 0);
    std::uint32_t number = pictures.first_pass;
    for (std::uint32_t picture = 0; picture < pictures.count; ++picture) {
        std::vector<double> light(pixels, 0);
        for (std::uint32_t p = 0; p < pictures.passes; ++p) {
            const PassResult pass = render_pass(scene, settings, number++, epoch);
            for (std::size_t i = 0; i < pixels; ++i)
                light[i] += luminance(pixel_value(pass.image, i, aov)) / pictures.passes;
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            sum[i] += light[i] / pictures.count;
            squares[i] += light[i] * light[i] / pictures.count;
        }
    }
    PictureSpread spread;
    for (std::size_t i = 0; i < pixels; ++i) {
        spread.mean += sum[i] / static_cast<double>(pixels);
        spread.variance += (squares[i] - sum[i] * sum[i]) / static_cast<double>(pixels);
    }
    return spread;
}

}  // namespace sunfleck::engine::testing_support
