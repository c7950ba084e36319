// Plastic and metal, layer by layer.
#include "import/gltf/opaque.h"

#include "import/gltf/sheen.h"
#include "scene/additions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

std::optional<JsonPlace> extension_of(const std::optional<JsonPlace>& material,
                                      std::string_view name) {
    return material ? material->extension(name) : std::nullopt;
}

/// Returns a diffuse base under a clear coat.
CoatedDiffuseMaterial plastic_of(const GltfPbr& pbr, std::shared_ptr<const Coat> coat) {
    CoatedDiffuseMaterial plastic;
    plastic.reflectance = base_colour(pbr);
    plastic.coat = std::move(coat);
    plastic.whole = true;
    return plastic;
}

ConductorMaterial metal_of(const GltfPbr& pbr) {
    ConductorMaterial metal;
    metal.reflectance = base_colour(pbr);
    metal.roughness = roughness_of(pbr);
    return metal;
}

/// Returns the index whose reflection along the normal is that of `ior` times a factor.
double index_with(double ior, double factor) {
    constexpr double kMostReflected = 0.9;
    const double amplitude = (ior - 1) / (ior + 1);
    const double root = std::sqrt(std::min(kMostReflected, factor * amplitude * amplitude));
    return (1 + root) / (1 - root);
}

double film_index_of(const JsonPlace& film) {
    constexpr double kMostIndex = 10;
    return film.number("iridescenceIor", 1.3, 1, kMostIndex);
}

/// Returns what is lost where a film is left out: the reflection along the normal, whose extremes
/// are those of two faces in phase and out of phase.
std::string without_film(double ior, double film) {
    const auto squared = [](double x) { return x * x; };
    const auto face = [](double above, double below) { return (above - below) / (above + below); };
    const double plain = squared(face(1, ior));
    const double top = face(1, film);
    const double bottom = face(film, ior);
    const double in_phase = squared((top + bottom) / (1 + top * bottom));
    const double out_of_phase = squared((top - bottom) / (1 - top * bottom));
    return fmt::format(
        "no film lies on what is not metal: it reflects {:.1f}% along the normal at all "
        "wavelengths, with the film {:.1f}% to {:.1f}%",
        100 * plain, 100 * std::min(in_phase, out_of_phase),
        100 * std::max(in_phase, out_of_phase));
}

}  // namespace

std::uint32_t GltfSurface::add(Material material) {
    return add_material(scene_, std::move(material), bump_map_);
}

std::uint32_t GltfSurface::add_opaque(const GltfPbr& pbr,
                                      const std::optional<JsonPlace>& material) {
    const auto clearcoat = extension_of(material, "KHR_materials_clearcoat");
    if (!clearcoat) return add_uncoated(pbr, material);
    const double factor = clearcoat->number("clearcoatFactor", 0, 0, 1);
    const auto slot =
        factor > 0 ? textures_.find(*clearcoat, "clearcoatTexture", TexelUse::red, pbr.vertices)
                   : std::nullopt;
    return add_mix([&] { return add_uncoated(pbr, material); },
                   [&] { return add_coated(pbr, *material, *clearcoat); }, number_of(slot, factor));
}

/// A coat hides that of plastic: between two layers of one index nothing is reflected.
std::uint32_t GltfSurface::add_coated(const GltfPbr& pbr, const JsonPlace& material,
                                      const JsonPlace& clearcoat) {
    constexpr double kIndex = 1.5;
    const double roughness = clearcoat.number("clearcoatRoughnessFactor", 0, 0, 1);
    const auto slot =
        textures_.find(clearcoat, "clearcoatRoughnessTexture", TexelUse::green, pbr.vertices);
    if (clearcoat.find("clearcoatNormalTexture") || !is_flat(bump_map_))
        scene_.warnings.add(clearcoat.where(), "the coat has the normals of what it covers");
    if (const auto sheen = material.extension("KHR_materials_sheen"))
        scene_.warnings.add(sheen->where(), "sheen is left out under a coat");
    return add_steps(steps_of(slot, roughness), 0, [&](const std::optional<Ggx>& facets) {
        const auto coat = coats_.of(kIndex, facets);
        return add_mix([&] { return add(plastic_of(pbr, coat)); },
                       [&] {
                           return add(CoatedConductorMaterial{metal_of(pbr), coat});
                       },
                       metallic_of(pbr));
    });
}

std::uint32_t GltfSurface::add_uncoated(const GltfPbr& pbr,
                                        const std::optional<JsonPlace>& material) {
    const auto sheen = extension_of(material, "KHR_materials_sheen");
    const auto layer = sheen ? sheen_of(*sheen, textures_, pbr.vertices) : std::nullopt;
    if (!layer) return add_unsheened(pbr, material);
    scene_.warnings.add(sheen->where(),
                        "sheen is a matt layer of its colour and mean brightness: "
                        "it has no bright rim");
    return add_mix([&] { return add_unsheened(pbr, material); },
                   [&] { return add(DiffuseMaterial{layer->colour}); }, layer->amount);
}

std::uint32_t GltfSurface::add_unsheened(const GltfPbr& pbr,
                                         const std::optional<JsonPlace>& material) {
    return add_mix([&] { return add_dielectric(pbr, material); },
                   [&] { return add_metal(pbr, material); }, metallic_of(pbr));
}

/// Light that diffuse transmission lets through meets no coat.
std::uint32_t GltfSurface::add_dielectric(const GltfPbr& pbr,
                                          const std::optional<JsonPlace>& material) {
    if (const auto film = extension_of(material, "KHR_materials_iridescence"))
        if (film->number("iridescenceFactor", 0, 0, 1) > 0)
            scene_.warnings.add(film->where(), without_film(pbr.ior, film_index_of(*film)));
    const auto sheet = extension_of(material, "KHR_materials_diffuse_transmission");
    if (!sheet) return add_plastic(pbr, material);
    const double factor = sheet->number("diffuseTransmissionFactor", 0, 0, 1);
    const auto amount =
        textures_.find(*sheet, "diffuseTransmissionTexture", TexelUse::alpha, pbr.vertices);
    const auto colour =
        textures_.find(*sheet, "diffuseTransmissionColorTexture", TexelUse::colour, pbr.vertices);
    const Vec3d passing = sheet->triple("diffuseTransmissionColorFactor", Vec3d(1));
    const auto add_sheet = [&] {
        return add(DiffuseTransmissionMaterial{Spectrum::constant(0), colour_of(colour, passing)});
    };
    return add_mix([&] { return add_plastic(pbr, material); }, add_sheet,
                   number_of(amount, factor));
}

std::uint32_t GltfSurface::add_plastic(const GltfPbr& pbr,
                                       const std::optional<JsonPlace>& material) {
    if (pbr.direction)
        scene_.warnings.add(pbr.direction->place.where(),
                            "a coat's anisotropy takes the mean of this texture's strength");
    const auto specular = extension_of(material, "KHR_materials_specular");
    double ior = std::min(pbr.ior, index_with(kInfiniteIndex, 1));
    FloatTexture matt = 0.0F;  // the share without any coat
    if (specular) {
        const Vec3d colour = specular->triple("specularColorFactor", Vec3d(1));
        if (specular->find("specularColorTexture") || colour != Vec3d(colour.x))
            scene_.warnings.add(specular->where(),
                                "the colour of reflection is left out: its luminance counts");
        ior = index_with(pbr.ior, 0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z);
        const double factor = specular->number("specularFactor", 1, 0, 1);
        const auto slot =
            textures_.find(*specular, "specularTexture", TexelUse::alpha, pbr.vertices);
        const FloatTexture coated = number_of(slot, factor);
        if (coated.is_constant())
            matt = 1 - coated.constant();
        else
            matt = FloatTexture(FloatKind{MixKind<FloatTexture>{1.0F, 0.0F, coated}});
    }
    const auto add_with_coat = [&](const std::optional<Ggx>& facets) {
        return add(plastic_of(pbr, coats_.of(ior, facets)));
    };
    const double strength = pbr.anisotropy * mean_of(pbr.direction);
    return add_mix(
        [&] { return add_steps(steps_of(pbr.green, pbr.roughness), strength, add_with_coat); },
        [&] { return add(DiffuseMaterial{base_colour(pbr)}); }, matt);
}

std::uint32_t GltfSurface::add_metal(const GltfPbr& pbr, const std::optional<JsonPlace>& material) {
    const auto film = extension_of(material, "KHR_materials_iridescence");
    const double factor = film ? film->number("iridescenceFactor", 0, 0, 1) : 0;
    if (factor == 0) return add(metal_of(pbr));
    constexpr double kMostNanometres = 1e6;
    const double least = film->number("iridescenceThicknessMinimum", 100, 0, kMostNanometres);
    const double most = film->number("iridescenceThicknessMaximum", 400, 0, kMostNanometres);
    IridescentConductorMaterial coloured;
    coloured.metal = metal_of(pbr);
    coloured.film_eta = static_cast<float>(film_index_of(*film));
    coloured.thickness = static_cast<float>(most);
    if (const auto slot =
            textures_.find(*film, "iridescenceThicknessTexture", TexelUse::green, pbr.vertices))
        coloured.thickness = FloatTexture(FloatKind{MixKind<FloatTexture>{
            static_cast<float>(least), static_cast<float>(most), number_of(slot, 1)}});
    const auto amount = textures_.find(*film, "iridescenceTexture", TexelUse::red, pbr.vertices);
    return add_mix([&] { return add(metal_of(pbr)); }, [&] { return add(coloured); },
                   number_of(amount, factor));
}

}  // namespace sunfleck::engine
