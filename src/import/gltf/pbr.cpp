// Reading of metallic-roughness, and its textures, texel by texel.
#include "import/gltf/pbr.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns an image of one channel, each texel changed; a number where all are the same.
template <class Change>
FloatTexture changed(const GltfTextures::Slot& slot, const Change& change) {
    const Image& from = *slot.image.image;
    const Vec2i size = from.resolution();
    std::vector<half> texels;
    texels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) texels.emplace_back(change(from.at(x, y)[0]));
    const bool is_even = std::all_of(texels.begin(), texels.end(),
                                     [&](half texel) { return texel == texels.front(); });
    if (is_even && !texels.empty()) return static_cast<float>(texels.front());
    FloatImageKind kind{slot.image};
    kind.image = std::make_shared<const Image>(size, 1, std::move(texels));
    return FloatTexture(FloatKind{std::move(kind)});
}

void read_anisotropy(const JsonPlace& material, GltfTextures& textures, GltfPbr& pbr) {
    const auto extension = material.extension("KHR_materials_anisotropy");
    if (!extension) return;
    pbr.anisotropy = extension->number("anisotropyStrength", 0, 0, 1);
    if (pbr.anisotropy > 0)
        pbr.direction =
            textures.find(*extension, "anisotropyTexture", TexelUse::blue, pbr.vertices);
}

/// Returns the alphas along and across the tangent. @param strength  of the anisotropy.
Vec2 alphas_of(double roughness, double strength) {
    const double alpha = roughness * roughness;
    const double along = alpha + (1 - alpha) * strength * strength;
    return {static_cast<float>(along), static_cast<float>(alpha)};
}

/// Returns how far each texel of a roughness is between two others, in [0,1].
FloatTexture share_beyond(const GltfTextures::Slot& slot, double factor, double from, double to) {
    const Image& image = *slot.image.image;
    const Vec2i size = image.resolution();
    std::vector<std::uint8_t> texels;  // several images of one texture: small
    texels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double roughness = factor * static_cast<double>(image.at(x, y)[0]);
            const double share = std::clamp((roughness - from) / (to - from), 0.0, 1.0);
            texels.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
        }
    FloatImageKind kind{slot.image};
    kind.image =
        std::make_shared<const Image>(size, 1, std::move(texels), Encoding{Encoding::Kind::linear});
    return FloatTexture(FloatKind{std::move(kind)});
}

}  // namespace

GltfPbr pbr_of(const std::optional<JsonPlace>& material, GltfTextures& textures,
               const GltfVertices& vertices) {
    GltfPbr pbr;
    pbr.vertices = vertices;
    if (!material) return pbr;
    if (const auto e = material->extension("KHR_materials_ior")) {
        const bool is_infinite = e->number("ior", 1.5) == 0;
        pbr.ior = is_infinite ? kInfiniteIndex : e->number("ior", 1.5, 1, kInfiniteIndex);
    }
    read_anisotropy(*material, textures, pbr);
    const auto place = material->find("pbrMetallicRoughness");
    if (!place) return pbr;
    if (const auto factor = place->find("baseColorFactor")) {
        const std::vector<double> v = factor->numbers(4);
        pbr.base = {v[0], v[1], v[2]};
        pbr.alpha = v[3];
    }
    pbr.metallic = place->number("metallicFactor", 1, 0, 1);
    pbr.roughness = place->number("roughnessFactor", 1, 0, 1);
    pbr.colour = textures.find(*place, "baseColorTexture", TexelUse::colour, vertices);
    if (pbr.colour && pbr.colour->image.image->channels() == 4)
        pbr.opacity = textures.find(*place, "baseColorTexture", TexelUse::alpha, vertices);
    if (pbr.roughness > 0)
        pbr.green = textures.find(*place, "metallicRoughnessTexture", TexelUse::green, vertices);
    if (pbr.metallic > 0)
        pbr.blue = textures.find(*place, "metallicRoughnessTexture", TexelUse::blue, vertices);
    return pbr;
}

SpectrumTexture colour_of(const std::optional<GltfTextures::Slot>& slot, const Vec3d& factor) {
    if (!slot) return Spectrum::rgb_albedo(Vec3(factor));
    SpectrumImageKind kind{slot->image, ColourUse::albedo};
    kind.image = coloured(kind.image, factor);
    return SpectrumTexture(SpectrumKind{std::move(kind)});
}

SpectrumTexture base_colour(const GltfPbr& pbr) {
    const GltfVertices& vertices = pbr.vertices;
    if (!vertices.colours) return colour_of(pbr.colour, pbr.base);
    std::vector<Vec3> colours = *vertices.colours;
    for (Vec3& colour : colours) colour *= Vec3(pbr.base);
    VertexColourKind kind;
    kind.colours = {vertices.triangles,
                    std::make_shared<const std::vector<Vec3>>(std::move(colours))};
    if (pbr.colour) kind.image = pbr.colour->image;
    return SpectrumTexture(SpectrumKind{std::move(kind)});
}

FloatTexture number_of(const std::optional<GltfTextures::Slot>& slot, double factor) {
    const auto scale = static_cast<float>(factor);
    if (!slot || scale == 0) return scale;
    return changed(*slot, [&](float value) { return scale * value; });
}

FloatTexture alpha_of(const GltfPbr& pbr) {
    FloatTexture alpha = static_cast<float>(pbr.alpha);
    const auto multiply = [&](FloatKind kind) {
        alpha =
            FloatTexture(FloatKind{ScaledKind<FloatTexture>{FloatTexture(std::move(kind)), alpha}});
    };
    if (pbr.opacity) multiply(FloatKind{FloatImageKind{pbr.opacity->image}});
    if (pbr.vertices.alphas)
        multiply(FloatKind{VertexNumberKind{{pbr.vertices.triangles, pbr.vertices.alphas}}});
    return alpha;
}

Roughness roughness_of(const GltfPbr& pbr) {
    const auto alphas = [&](double strength) -> FloatTexture {
        if (!pbr.green) return alphas_of(pbr.roughness, strength).x;
        return changed(*pbr.green, [&](float r) {
            return alphas_of(pbr.roughness * static_cast<double>(r), strength).x;
        });
    };
    const FloatTexture across = alphas(0);
    if (pbr.anisotropy == 0) return {across, across, false, true};
    if (!pbr.direction) return {alphas(pbr.anisotropy), across, false, true};
    // alpha + (1 - alpha) strength^2
    const FloatTexture squares = changed(*pbr.direction, [&](float strength) {
        const double s = pbr.anisotropy * static_cast<double>(strength);
        return static_cast<float>(s * s);
    });
    return {FloatTexture(FloatKind{MixKind<FloatTexture>{across, 1.0F, squares}}), across, false,
            true};
}

FloatTexture metallic_of(const GltfPbr& pbr) {
    return number_of(pbr.blue, pbr.metallic);
}

double mean_of(const std::optional<GltfTextures::Slot>& slot) {
    if (!slot) return 1;
    const Image& image = *slot->image.image;
    const Vec2i size = image.resolution();
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) sum += static_cast<double>(image.at(x, y)[0]);
    return sum / (static_cast<double>(size.x) * size.y);
}

std::optional<Ggx> facets_of(double roughness, double strength) {
    const Vec2 alphas = alphas_of(roughness, strength);
    if (std::max(alphas.x, alphas.y) < kSmoothAlpha) return {};
    return Ggx{std::max(alphas.x, 1e-4F), std::max(alphas.y, 1e-4F)};
}

RoughnessSteps steps_of(const std::optional<GltfTextures::Slot>& slot, double factor) {
    constexpr double kSteps = 8;
    constexpr double kEven = 1.0 / 64;
    if (!slot || factor == 0) return {{factor}, {}};
    const Image& image = *slot->image.image;
    double least = 1;
    double most = 0;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const double roughness = factor * static_cast<double>(image.at(x, y)[0]);
            least = std::min(least, roughness);
            most = std::max(most, roughness);
        }
    if (!(most - least > kEven)) return {{factor * mean_of(slot)}, {}};
    RoughnessSteps steps;
    for (double step = std::floor(least * kSteps); step <= std::ceil(most * kSteps); ++step) {
        if (!steps.roughness.empty())
            steps.amounts.push_back(
                share_beyond(*slot, factor, steps.roughness.back(), step / kSteps));
        steps.roughness.push_back(step / kSteps);
    }
    return steps;
}

}  // namespace sunfleck::engine
