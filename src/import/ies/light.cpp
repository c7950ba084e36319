// Means over texels.
#include "import/ies/light.h"

#include "core/parallel.h"
#include "light/lumens.h"
#include "math/warp.h"

namespace sunfleck::engine {

std::shared_ptr<const LightImage> intensity_map(const Photometry& photometry) {
    constexpr std::size_t kSide = 512;   // texels of two fifths of a degree
    constexpr std::size_t kSamples = 3;  // of a texel, along each side
    std::vector<float> texels(kSide * kSide);
    const auto place = [](std::size_t texel, std::size_t sample) {
        return (static_cast<double>(texel) + (static_cast<double>(sample) + 0.5) / kSamples) /
               kSide;
    };
    parallel_for(kSide, [&](std::size_t y) {
        for (std::size_t x = 0; x < kSide; ++x) {
            double sum = 0;
            for (std::size_t i = 0; i < kSamples * kSamples; ++i)
                sum += photometry.candela(
                    uniform_sphere({place(x, i % kSamples), place(y, i / kSamples)}));
            texels[y * kSide + x] = static_cast<float>(sum / (kSamples * kSamples));
        }
    });
    constexpr auto kPixels = static_cast<int>(kSide);
    return std::make_shared<const LightImage>(Image({kPixels, kPixels}, 1, std::move(texels)));
}

Spectrum per_candela(const Spectrum& colour) {
    const double luminance = colour.luminance();
    return luminance > 0 ? colour.scaled(static_cast<float>(1 / (kLumensPerWatt * luminance)))
                         : colour;
}

}  // namespace sunfleck::engine
