// Conversion of materials, part by part.
#include "import/gltf/materials.h"

#include "import/gltf/glass.h"
#include "import/gltf/units.h"
#include "light/surface_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr double kMost = std::numeric_limits<double>::infinity();

GltfPbr pbr_of(const std::optional<JsonPlace>& material, GltfTextures& textures) {
    GltfPbr pbr;
    const auto place = material ? material->find("pbrMetallicRoughness") : std::nullopt;
    if (!place) return pbr;
    if (const auto factor = place->find("baseColorFactor")) {
        const std::vector<double> v = factor->numbers(4);
        pbr.base = {v[0], v[1], v[2]};
        pbr.alpha = v[3];
    }
    pbr.metallic = place->number("metallicFactor", 1, 0, 1);
    pbr.roughness = place->number("roughnessFactor", 1, 0, 1);
    pbr.colour = textures.find(*place, "baseColorTexture", TexelUse::colour, pbr.uv_set);
    if (pbr.roughness > 0)
        pbr.green = textures.find(*place, "metallicRoughnessTexture", TexelUse::green, pbr.uv_set);
    if (pbr.metallic > 0)
        pbr.blue = textures.find(*place, "metallicRoughnessTexture", TexelUse::blue, pbr.uv_set);
    return pbr;
}

/// Returns an image of one channel, each texel changed.
template <class Change>
FloatTexture changed(const GltfTextures::Slot& slot, const Change& change) {
    const Image& from = *slot.image.image;
    const Vec2i size = from.resolution();
    std::vector<half> texels;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) texels.emplace_back(change(from.at(x, y)[0]));
    FloatImageKind kind{slot.image};
    kind.image = std::make_shared<const Image>(size, 1, std::move(texels));
    return FloatTexture(FloatKind{std::move(kind)});
}

double mean_of(const Image& image) {
    const Vec2i size = image.resolution();
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) sum += static_cast<double>(image.at(x, y)[0]);
    return sum / (static_cast<double>(size.x) * size.y);
}

SpectrumTexture colour_of(const std::optional<GltfTextures::Slot>& slot, const Vec3d& factor) {
    if (!slot) return Spectrum::rgb_albedo(Vec3(factor));
    SpectrumImageKind kind{slot->image, ColourUse::albedo};
    kind.image = coloured(kind.image, factor);
    return SpectrumTexture(SpectrumKind{std::move(kind)});
}

/// Returns the GGX alphas, the square of the roughness.
Roughness roughness_of(const GltfPbr& pbr) {
    const auto scale = static_cast<float>(pbr.roughness);
    FloatTexture alpha = scale * scale;
    if (pbr.green) alpha = changed(*pbr.green, [&](float r) { return scale * r * (scale * r); });
    return {alpha, alpha, false, true};
}

FloatTexture metallic_of(const GltfPbr& pbr) {
    const auto scale = static_cast<float>(pbr.metallic);
    if (!pbr.blue) return scale;
    return changed(*pbr.blue, [&](float m) { return scale * m; });
}

/// Returns a diffuse base under a clear coat. A coat has one roughness: of a texture the mean.
CoatedDiffuseMaterial plastic_of(const GltfPbr& pbr, double eta) {
    double roughness = pbr.roughness;
    if (pbr.green) roughness *= mean_of(*pbr.green->image.image);
    const auto alpha = static_cast<float>(roughness * roughness);
    std::optional<Ggx> facets;
    if (alpha >= kSmoothAlpha) facets = Ggx{alpha, alpha};
    CoatedDiffuseMaterial plastic;
    plastic.reflectance = colour_of(pbr.colour, pbr.base);
    plastic.coat = std::make_shared<const Coat>(static_cast<float>(eta), facets, 0.0F);
    plastic.whole = true;
    return plastic;
}

ConductorMaterial metal_of(const GltfPbr& pbr) {
    ConductorMaterial metal;
    metal.reflectance = colour_of(pbr.colour, pbr.base);
    metal.roughness = roughness_of(pbr);
    return metal;
}

/// Returns the refractive index by Cauchy's law through `ior` at the d line.
/// @param dispersion  20 over Abbe's number (KHR_materials_dispersion).
Spectrum index_of(double ior, double dispersion) {
    if (!(dispersion > 0)) return Spectrum::constant(static_cast<float>(ior));
    constexpr double kD = 587.56;  // nm: Fraunhofer's lines d, F and C
    constexpr double kF = 486.13;
    constexpr double kC = 656.27;
    const double abbe = 20 / dispersion;
    const double b = (ior - 1) / (abbe * (1 / (kF * kF) - 1 / (kC * kC)));
    const double a = ior - b / (kD * kD);
    std::vector<TabulatedSpectrum::Point> points;
    for (int nm = 360; nm <= 830; nm += 5)
        points.push_back({static_cast<float>(nm), static_cast<float>(a + b / (nm * nm))});
    return Spectrum::table(std::move(points));
}

BumpMap normal_map_of(const JsonPlace& material, GltfTextures& textures,
                      std::optional<std::uint64_t>& uv_set) {
    const auto slot = textures.find(material, "normalTexture", TexelUse::linear, uv_set);
    if (!slot) return {};
    const auto strength = static_cast<float>(slot->place.number("scale", 1));
    return NormalMap{slot->image.image, slot->image.mapping, slot->image.wraps, strength, true};
}

std::optional<AreaEmission> emission_of(const JsonPlace& material, GltfTextures& textures,
                                        std::optional<std::uint64_t>& uv_set) {
    Vec3d colour = material.triple("emissiveFactor", Vec3d(0));
    double strength = 1;
    if (const auto extension = material.extension("KHR_materials_emissive_strength"))
        strength = extension->number("emissiveStrength", 1, 0, kMostLight);
    if (!(std::max({colour.x, colour.y, colour.z}) * strength > 0)) return {};
    AreaEmission emission;
    emission.two_sided = material.flag("doubleSided", false);
    const auto scale = static_cast<float>(strength / kLumensPerWatt);
    emission.radiance = Spectrum::rgb_illuminant(Vec3(colour)).scaled(scale);
    if (const auto slot = textures.find(material, "emissiveTexture", TexelUse::colour, uv_set)) {
        emission.image = std::make_shared<const SurfaceImage>(
            coloured(slot->image.image, colour)->with_channels(3));
        emission.radiance = Spectrum::d65().scaled(scale);
    }
    return emission;
}

}  // namespace

GltfMaterials::GltfMaterials(GltfDocument& document, SceneDescription& scene)
    : document_(document), scene_(scene), textures_(document, scene.warnings) {}

std::uint32_t GltfMaterials::add(Material material, const BumpMap& bump_map) {
    scene_.materials.push_back(std::move(material));
    scene_.bump_maps.push_back(bump_map);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

const GltfLook& GltfMaterials::look_of(const JsonPlace& primitive) {
    const auto number = primitive.find("material");
    std::optional<std::size_t> key;
    if (number) key = number->index(document_.count("materials"), "material");
    const auto known = looks_.find(key);
    if (known != looks_.end()) return known->second;
    std::optional<JsonPlace> place;
    if (number) place = document_.element("materials", *number);
    return looks_.emplace(key, made(place)).first->second;
}

MediumNumber GltfMaterials::medium_of(const Vec3d& absorption) {
    scene_.media.absorption.push_back(Spectrum::rgb_unbounded(Vec3(absorption)));
    return static_cast<MediumNumber>(scene_.media.absorption.size() - 1);
}

/// Returns the material of all that does not pass light on: plastic, metal, or both.
std::uint32_t GltfMaterials::add_opaque(const GltfPbr& pbr, double ior, const BumpMap& bump_map) {
    const FloatTexture metallic = metallic_of(pbr);
    const auto is_always = [&](float value) {
        return metallic.is_constant() && metallic.constant() == value;
    };
    if (is_always(1)) return add(metal_of(pbr), bump_map);
    if (pbr.green)
        scene_.warnings.add(pbr.green->place.where(),
                            "what is not metal takes the mean of this texture's roughness");
    if (is_always(0)) return add(plastic_of(pbr, ior), bump_map);
    const std::uint32_t plastic = add(plastic_of(pbr, ior), bump_map);
    const std::uint32_t metal = add(metal_of(pbr), bump_map);
    return add(MixMaterial{{plastic, metal}, metallic}, bump_map);
}

/// Adds glass in the place of what is opaque, as far as the material transmits.
void GltfMaterials::add_glass(const JsonPlace& material, GltfPbr& pbr, double ior,
                              const BumpMap& bump_map, GltfLook& look) {
    const auto transmission = material.extension("KHR_materials_transmission");
    if (!transmission) return;
    const auto factor = static_cast<float>(transmission->number("transmissionFactor", 0, 0, 1));
    if (factor == 0) return;
    FloatTexture amount = factor;
    if (const auto slot =
            textures_.find(*transmission, "transmissionTexture", TexelUse::red, pbr.uv_set))
        amount = changed(*slot, [&](float t) { return factor * t; });
    const auto mixed = [&](Material glass) {
        const std::uint32_t number = add(std::move(glass), bump_map);
        const bool is_all = amount.is_constant() && amount.constant() == 1;
        return is_all ? number : add(MixMaterial{{look.material, number}, amount}, bump_map);
    };
    double dispersion = 0;
    if (const auto e = material.extension("KHR_materials_dispersion"))
        dispersion = e->number("dispersion", 0, 0, kMost);
    const Spectrum eta = index_of(ior, dispersion);
    GltfLook::Glass glass;
    glass.pane = mixed(ThinDielectricMaterial{eta});
    glass.colour = pbr.base;
    if (const auto volume = material.extension("KHR_materials_volume")) {
        glass.has_volume = volume->number("thicknessFactor", 0, 0, kMost) > 0;
        const double distance = volume->number("attenuationDistance", kMost, 0, kMost);
        const Vec3d colour = volume->triple("attenuationColor", Vec3d(1));
        if (glass.has_volume && distance > 0) glass.absorption = absorption_over(distance, colour);
    }
    look.material = mixed(DielectricMaterial{eta, roughness_of(pbr)});
    if (pbr.colour)
        scene_.warnings.add(pbr.colour->place.where(),
                            "the texture of glass is left out: its factor alone colours it");
    look.glass = glass;
}

/// Adds what alpha leaves of the surface.
void GltfMaterials::add_alpha(const JsonPlace& material, const GltfPbr& pbr, GltfLook& look) {
    const std::string mode = material.text("alphaMode", "OPAQUE");
    if (mode == "OPAQUE") return;
    if (mode != "MASK" && mode != "BLEND")
        material.at("alphaMode").refuse("is no mode of alpha", "write OPAQUE, MASK or BLEND");
    auto factor = static_cast<float>(pbr.alpha);
    FloatTexture alpha = factor;
    if (pbr.colour && pbr.colour->image.image->channels() == 4) {
        const FloatTexture of_image(FloatKind{FloatImageKind{pbr.colour->image}});
        alpha = FloatTexture(FloatKind{ScaledKind<FloatTexture>{of_image, factor}});
    }
    if (mode == "MASK") {
        const auto cutoff = static_cast<float>(material.number("alphaCutoff", 0.5));
        look.cover = [alpha, cutoff](const Hit& hit) {
            return alpha.at(TexturePoint(hit)) >= cutoff ? 1.0F : 0.0F;
        };
    } else if (!alpha.is_constant() || alpha.constant() < 1) {
        look.cover = cover_by(alpha);
        look.alpha = alpha;
    }
}

GltfLook GltfMaterials::made(const std::optional<JsonPlace>& material) {
    GltfPbr pbr = pbr_of(material, textures_);
    GltfLook look;
    if (!material) {
        look.material = add_opaque(pbr, 1.5, {});
        return look;
    }
    double ior = 1.5;
    if (const auto e = material->extension("KHR_materials_ior"))
        ior = e->number("ior", 1.5, 1, kMost);
    const BumpMap bump_map = normal_map_of(*material, textures_, pbr.uv_set);
    look.emission = emission_of(*material, textures_, pbr.uv_set);
    look.material = add_opaque(pbr, ior, bump_map);
    add_alpha(*material, pbr, look);
    add_glass(*material, pbr, ior, bump_map, look);
    look.uv_set = pbr.uv_set.value_or(0);
    return look;
}

}  // namespace sunfleck::engine
