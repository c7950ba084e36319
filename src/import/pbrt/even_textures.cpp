// Means over a grid of 16 x 16 points.
#include "import/pbrt/even_textures.h"

#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

/// Images are wanted now, not only when all is read.
void prepare(const Statement& statement, const std::string& name, Assets& assets) {
    assets.log.warn(statement.find(name)->where,
                    "the texture of " + in_quotes(name) + " counts as its mean over its square");
    assets.images.load();
}

/// @param value  at a point.
template <class Value>
float mean_over_square(const Value& value) {
    constexpr int kSide = 16;
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const Vec2 uv((static_cast<float>(i) + 0.5F) / kSide,
                          (static_cast<float>(j) + 0.5F) / kSide);
            sum += static_cast<double>(value(TexturePoint({uv.x, uv.y, 0}, {0, 0, 1}, uv)));
        }
    return static_cast<float>(sum / (kSide * kSide));
}

}  // namespace

std::optional<float> even_number(const Statement& statement, const std::string& name,
                                 Assets& assets) {
    const auto texture = assets.textures.find_number(statement, name);
    if (!texture) return {};
    if (texture->is_constant()) return texture->constant();
    prepare(statement, name, assets);
    return mean_over_square([&](const TexturePoint& point) { return texture->at(point); });
}

std::optional<Spectrum> even_curve(const Statement& statement, const std::string& name,
                                   SpectrumUse use, Assets& assets) {
    const auto texture = assets.textures.find_spectrum(statement, name, use);
    if (!texture) return {};
    if (texture->is_constant()) return texture->curve();
    prepare(statement, name, assets);
    return tabulated([&](float nm) {
        Wavelengths one;
        one.nm.fill(nm);
        return mean_over_square(
            [&](const TexturePoint& point) { return std::max(0.0F, texture->at(point, one)[0]); });
    });
}

Spectrum tabulated(const std::function<float(float)>& value) {
    std::vector<TabulatedSpectrum::Point> points;
    for (int i = 360; i <= 830; i += 5) {
        const auto nm = static_cast<float>(i);
        points.push_back({nm, value(nm)});
    }
    return Spectrum::table(std::move(points));
}

}  // namespace sunfleck::engine
