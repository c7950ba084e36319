// The film's reflectance, one wavelength at a time.
#include "export/film_colours.h"

#include "bsdf/thin_film.h"
#include "export/spectra.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {

std::optional<Spectrum> film_colour(const IridescentConductorMaterial& material) {
    const auto& metal = material.metal.reflectance;
    if (!metal || !metal->is_constant()) return {};
    constexpr int kSide = 8;
    std::array<float, kSide * kSide> thicknesses{};
    for (int i = 0; i < kSide * kSide; ++i) {
        TexturePoint point;
        point.uv =
            (Vec2(static_cast<float>(i % kSide), static_cast<float>(i / kSide)) + Vec2(0.5F)) /
            kSide;
        thicknesses.at(static_cast<std::size_t>(i)) = std::max(0.0F, material.thickness.at(point));
    }
    return sparse_table([&](float nm) {
        const float r = std::clamp(metal->curve()(nm), 0.0F, 0.9999F);
        const SampledSpectrum k(2 * std::sqrt(r) / std::sqrt(1 - r));
        double sum = 0;
        for (const float thickness : thicknesses) {
            const ThinFilm film{material.film_eta, SampledSpectrum(thickness / nm)};
            sum += static_cast<double>(film_reflectance(1, film, SampledSpectrum(1), k)[0]);
        }
        return static_cast<float>(sum / thicknesses.size());
    });
}

}  // namespace sunfleck::engine
