// Sums over the visible range of curve times smooth spectrum times observer.
#include "export/light_colours.h"

#include "core/parallel.h"
#include "export/spectra.h"
#include "math/colour.h"
#include "math/sigmoid_table.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr int kStep = 5;  // nm
constexpr std::size_t kCount = (kLastNm - kFirstNm) / kStep + 1;
constexpr std::size_t kBlocks = (kCount + kWavelengths - 1) / kWavelengths;

float nm_at(std::size_t i) {
    return static_cast<float>(kFirstNm + kStep * static_cast<int>(std::min(i, kCount - 1)));
}

/// The wavelengths block by block; the last block repeats the last one.
std::array<Wavelengths, kBlocks> made_blocks() {
    std::array<Wavelengths, kBlocks> blocks;
    for (std::size_t i = 0; i < kBlocks * kWavelengths; ++i)
        blocks.at(i / kWavelengths).nm.at(i % kWavelengths) = nm_at(i);
    return blocks;
}

}  // namespace

LightColours::LightColours(const Spectrum& curve) {
    if (is_d65(curve)) {
        scale_ = curve.factor();
        return;
    }
    SigmoidTable::srgb();  // built now, because it may not be built within parallel work
    scale_ = curve.luminance();
    for (std::size_t i = 0; i < kCount; ++i)
        curve_.push_back(scale_ > 0 ? curve(nm_at(i)) / scale_ : 0);
    white_ = seen(Vec3(1));
}

Vec3 LightColours::of(const Vec3& texel) const {
    if (are_kept()) return texel;
    const bool is_grey = texel.x == texel.y && texel.y == texel.z;
    return is_grey ? white_ * texel.x : seen(texel);
}

Vec3 LightColours::seen(const Vec3& texel) const {
    static const std::array<Wavelengths, kBlocks> all = made_blocks();
    Vec3d sum(0);
    for (std::size_t block = 0; block < kBlocks; ++block) {
        const SampledSpectrum smooth = SigmoidTable::srgb().unbounded(texel, all.at(block));
        for (std::size_t k = 0; k < kWavelengths; ++k) {
            const std::size_t i = block * kWavelengths + k;
            if (i >= kCount) break;
            const Triple response = rgb_response(static_cast<double>(nm_at(i)));
            const double light = static_cast<double>(curve_[i] * smooth[k]) * kStep;
            for (int c = 0; c < 3; ++c) sum[c] += light * response[static_cast<std::size_t>(c)];
        }
    }
    return {Vec3d(std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0))};
}

std::shared_ptr<const Image> under(const LightColours& colours, const Image& image) {
    const Vec2i size = image.resolution();
    const auto width = static_cast<std::size_t>(size.x);
    std::vector<float> texels(3 * width * static_cast<std::size_t>(size.y));
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x) {
            const Vec3 rgb = colours.of(image.rgb(static_cast<int>(x), static_cast<int>(y)));
            std::copy(&rgb.x, &rgb.x + 3, &texels[3 * (y * width + x)]);
        }
    });
    return std::make_shared<const Image>(size, 3, std::move(texels));
}

}  // namespace sunfleck::engine
