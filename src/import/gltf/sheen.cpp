// The albedo of sheen by quadrature, and its colour texel by texel.
#include "import/gltf/sheen.h"

#include "math/trigonometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

/// The fit of masking in Conty Estevez and Kulla 2017, table 1.
double masking_exponent(double cosine, double alpha) {
    const double wide = (1 - alpha) * (1 - alpha);
    const auto mixed = [&](double rough, double smooth) { return rough + (smooth - rough) * wide; };
    const double a = mixed(21.5473, 25.3245);
    const double b = mixed(3.82987, 3.32435);
    const double c = mixed(0.19823, 0.16801);
    const double d = mixed(-1.97760, -1.27393);
    const double e = mixed(-4.32054, -4.85967);
    return a / (1 + b * std::pow(cosine, c)) + d * cosine + e;
}

double masking(double cosine, double alpha) {
    const double exponent =
        cosine < 0.5 ? masking_exponent(cosine, alpha)
                     : 2 * masking_exponent(0.5, alpha) - masking_exponent(1 - cosine, alpha);
    return std::exp(exponent);
}

double greatest(const Vec3& colour) {
    return static_cast<double>(std::max({colour.x, colour.y, colour.z}));
}

/// Returns the layer of a colour that varies by texels.
SheenLayer layer_of(const GltfTextures::Slot& slot, const Vec3d& factor, double albedo) {
    const Image& from = *slot.image.image;
    const Vec2i size = from.resolution();
    std::vector<half> amounts;
    std::vector<half> colours;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const Vec3 colour = from.rgb(x, y) * Vec3(factor);
            const double most = greatest(colour);
            amounts.emplace_back(static_cast<float>(albedo * std::min(1.0, most)));
            for (int c = 0; c < 3; ++c)
                colours.emplace_back(most > 0 ? colour[c] / static_cast<float>(most) : 0.0F);
        }
    FloatImageKind amount{slot.image};
    amount.image = std::make_shared<const Image>(size, 1, std::move(amounts));
    SpectrumImageKind colour{slot.image, ColourUse::albedo};
    colour.image = std::make_shared<const Image>(size, 3, std::move(colours));
    return {FloatTexture(FloatKind{std::move(amount)}),
            SpectrumTexture(SpectrumKind{std::move(colour)})};
}

}  // namespace

/// Twice the integral over both cosines and the azimuth between, by the midpoint rule. With
/// D = (2 + 1/alpha) sin^(1/alpha) / (2 pi) and V = 1 / ((1 + masking) 4 cos cos), the cosines of
/// the incoming and the outgoing direction cancel.
double mean_sheen_albedo(double roughness) {
    constexpr int kSteps = 32;
    constexpr double kLeast = 0.01;  // alpha; below, the albedo is next to nothing
    const double alpha = std::max(kLeast, roughness * roughness);
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double to = (i + 0.5) / kSteps;
        const double masked_to = masking(to, alpha);
        for (int j = 0; j < kSteps; ++j) {
            const double from = (j + 0.5) / kSteps;
            const double across = std::sqrt((1 - to * to) * (1 - from * from));
            double distribution = 0;
            for (int k = 0; k < kSteps; ++k) {
                const double along = to * from + across * sin_cos_2pi((k + 0.5) / kSteps).cos;
                const double cosine2 = (to + from) * (to + from) / (2 + 2 * along);
                distribution += std::pow(std::max(0.0, 1 - cosine2), 0.5 / alpha);
            }
            sum += distribution / (1 + masked_to + masking(from, alpha));
        }
    }
    // 2 / (2 pi) * 2 pi / 4: of the mean over diffuse light, of D, of the azimuth, and of V.
    return 0.5 * (2 + 1 / alpha) * sum / (double{kSteps} * kSteps * kSteps);
}

std::optional<SheenLayer> sheen_of(const JsonPlace& extension, GltfTextures& textures,
                                   const GltfVertices& vertices) {
    const Vec3d factor = extension.triple("sheenColorFactor", Vec3d(0));
    if (!(std::max({factor.x, factor.y, factor.z}) > 0)) return {};
    const double roughness =
        extension.number("sheenRoughnessFactor", 0, 0, 1) *
        mean_of(textures.find(extension, "sheenRoughnessTexture", TexelUse::alpha, vertices));
    const double albedo = mean_sheen_albedo(roughness);
    const auto slot = textures.find(extension, "sheenColorTexture", TexelUse::colour, vertices);
    if (slot) return layer_of(*slot, factor, albedo);
    const double most = std::max({factor.x, factor.y, factor.z});
    return SheenLayer{static_cast<float>(albedo * std::min(1.0, most)),
                      Spectrum::rgb_albedo(Vec3(factor / most))};
}

}  // namespace sunfleck::engine
