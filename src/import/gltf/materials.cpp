// Conversion of materials, part by part.
#include "import/gltf/materials.h"

#include "import/gltf/glass.h"
#include "import/gltf/units.h"
#include "light/surface_image.h"
#include "scene/additions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr double kMost = std::numeric_limits<double>::infinity();

bool is_positive(const Vec3d& colour) {
    return std::max({colour.x, colour.y, colour.z}) > 0;
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

/// Returns the number of a variant of the file, by its name.
std::optional<std::size_t> variant_named(const std::string& name, const GltfDocument& document) {
    if (name.empty()) return {};
    std::string names;
    if (const auto extension = document.root().extension("KHR_materials_variants")) {
        const std::vector<JsonPlace> variants = extension->elements("variants");
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const std::string known = variants[i].text("name", "");
            if (known == name) return i;
            names += (names.empty() ? "\"" : ", \"") + known + '"';
        }
    }
    throw Error(
        {document.path()}, "has no variant \"" + name + "\" (--variant)",
        names.empty() ? "leave --variant out: it has none at all" : "write one of " + names);
}

/// Adds the numbers of the texture coordinates that are asked for within a value.
/// @param depth  to which values are looked through; those of extensions lie 3 deep.
void add_uv_sets(const JsonPlace& place, int depth, std::vector<std::uint64_t>& sets) {
    for (const auto& [name, member] : place.members()) {
        const bool is_texture = name.ends_with("Texture") && !member.members().empty();
        if (is_texture) {
            const std::uint64_t set = uv_set_of(member);
            if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
        } else if (depth > 0) {
            add_uv_sets(member, depth - 1, sets);
        }
    }
}

/// Returns amount * (1 - by).
FloatTexture less(const FloatTexture& amount, const FloatTexture& by) {
    if (by.is_constant() && by.constant() == 0) return amount;
    return FloatTexture(FloatKind{MixKind<FloatTexture>{amount, 0.0F, by}});
}

/// Names the materials of a look as the file does.
void name_materials(const std::optional<JsonPlace>& place, const GltfLook& look,
                    SceneDescription& scene) {
    const std::string name = place ? place->text("name", "") : "default";
    name_material(scene, look.material, name);
    if (look.glass) name_material(scene, look.glass->pane, name);
}

std::string emission_in_watts(const std::string& generator) {
    return "emission is taken in W/(sr m2), because \"" + generator +
           "\" wrote the file (--emission-unit nit for what glTF says)";
}

}  // namespace

GltfMaterials::GltfMaterials(GltfDocument& document, SceneDescription& scene,
                             const ImportSettings& settings)
    : document_(document),
      scene_(scene),
      textures_(document, scene.warnings),
      variant_(variant_named(settings.variant, document)) {
    const bool is_of_blender = document.generator().starts_with("Khronos glTF Blender I/O");
    const EmissionUnit usual = is_of_blender ? EmissionUnit::watt : EmissionUnit::nit;
    is_in_watts_ = settings.emission_unit.value_or(usual) == EmissionUnit::watt;
    told_watts_ = settings.emission_unit.has_value();
}

std::optional<JsonPlace> GltfMaterials::material_of(const JsonPlace& primitive) const {
    auto number = primitive.find("material");
    const auto variants = primitive.extension("KHR_materials_variants");
    if (variant_ && variants)
        for (const JsonPlace& mapping : variants->elements("mappings"))
            for (const JsonPlace& of : mapping.elements("variants"))
                if (of.whole() == *variant_) number = mapping.at("material");
    return number;
}

std::vector<std::uint64_t> GltfMaterials::uv_sets_of(const JsonPlace& primitive) const {
    std::vector<std::uint64_t> sets;
    if (const auto number = material_of(primitive)) {
        const JsonPlace material = document_.element("materials", *number);
        // Emission and normal maps need coordinates of the mesh itself.
        if (is_positive(material.triple("emissiveFactor", Vec3d(0))))
            if (const auto info = material.find("emissiveTexture"))
                sets.push_back(uv_set_of(*info));
        if (const auto info = material.find("normalTexture"); info && sets.empty())
            sets.push_back(uv_set_of(*info));
        if (const auto pbr = material.find("pbrMetallicRoughness"); pbr && sets.empty())
            if (const auto info = pbr->find("baseColorTexture")) sets.push_back(uv_set_of(*info));
        add_uv_sets(material, 3, sets);
    }
    if (sets.empty()) sets.push_back(0);
    return sets;
}

const GltfLook& GltfMaterials::look_of(const JsonPlace& primitive, const GltfVertices& vertices) {
    const auto number = material_of(primitive);
    Key key;
    if (number) key.first = number->index(document_.count("materials"), "material");
    if (!vertices.are_plain())
        key.second = primitive.where().file;
    else if (!vertices.has_own_set)
        key.second = "without texture coordinates";
    const auto known = looks_.find(key);
    if (known != looks_.end()) return known->second;
    std::optional<JsonPlace> place;
    if (number) place = document_.element("materials", *number);
    GltfLook look = made(place, vertices);
    look.is_of_vertices = !vertices.are_plain();
    name_materials(place, look, scene_);
    return looks_.emplace(key, std::move(look)).first->second;
}

BumpMap GltfMaterials::normal_map_of(const JsonPlace& material, const GltfVertices& vertices) {
    const auto slot = textures_.find(material, "normalTexture", TexelUse::linear, vertices);
    if (!slot) return {};
    if (std::holds_alternative<VertexMapping>(slot->image.mapping)) {
        scene_.warnings.add(slot->place.where(),
                            "has other texture coordinates than the emission: the normal map is "
                            "left out");
        return {};
    }
    const auto strength = static_cast<float>(slot->place.number("scale", 1));
    return NormalMap{slot->image.image, slot->image.mapping, slot->image.wraps, strength, true};
}

void GltfMaterials::add_emission(const JsonPlace& material, const GltfVertices& vertices,
                                 GltfLook& look) {
    const Vec3d colour = material.triple("emissiveFactor", Vec3d(0));
    double strength = 1;
    if (const auto extension = material.extension("KHR_materials_emissive_strength"))
        strength = extension->number("emissiveStrength", 1, 0, kMostLight);
    if (!is_positive(colour * strength)) return;
    if (is_in_watts_ && !std::exchange(told_watts_, true))
        scene_.warnings.add(material.where(), emission_in_watts(document_.generator()));
    AreaEmission emission;
    emission.two_sided = material.flag("doubleSided", false);
    const auto scale = static_cast<float>(is_in_watts_ ? strength : strength / kLumensPerWatt);
    emission.radiance = Spectrum::rgb_illuminant(Vec3(colour)).scaled(scale);
    if (const auto slot = textures_.find(material, "emissiveTexture", TexelUse::colour, vertices)) {
        if (slot->place.extension("KHR_texture_transform"))
            scene_.warnings.add(slot->place.where(),
                                "the transform of a texture of emission is left out");
        emission.image = std::make_shared<const SurfaceImage>(
            coloured(slot->image.image, colour)->with_channels(3));
        emission.radiance = Spectrum::d65().scaled(scale);
    }
    look.emission = std::move(emission);
}

/// Adds glass, mixed with what is opaque as far as the material does not transmit. @return  false
/// if it transmits nothing.
bool GltfMaterials::add_glass(const JsonPlace& material, const GltfPbr& pbr, GltfSurface& surface,
                              GltfLook& look) {
    const auto transmission = material.extension("KHR_materials_transmission");
    if (!transmission) return false;
    const double factor = transmission->number("transmissionFactor", 0, 0, 1);
    if (factor == 0) return false;
    const FloatTexture amount = number_of(
        textures_.find(*transmission, "transmissionTexture", TexelUse::red, pbr.vertices), factor);
    const FloatTexture metallic = metallic_of(pbr);
    if (metallic.is_constant() && metallic.constant() == 1) return false;  // metal
    std::optional<std::uint32_t> opaque;
    const auto mixed = [&](Material glass) {
        const auto add_opaque = [&] {
            if (!opaque) opaque = surface.add_opaque(pbr, material);
            return *opaque;
        };
        const auto add_glass = [&] { return surface.add(std::move(glass)); };
        return surface.add_mix(add_opaque, add_glass, less(amount, metallic));
    };
    double dispersion = 0;
    if (const auto e = material.extension("KHR_materials_dispersion"))
        dispersion = e->number("dispersion", 0, 0, kMost);
    if (pbr.ior == kInfiniteIndex)
        scene_.warnings.add(material.where(), "glass of an infinite index: 1.5 is taken");
    const Spectrum eta = index_of(pbr.ior == kInfiniteIndex ? 1.5 : pbr.ior, dispersion);
    GltfLook::Glass glass;
    glass.pane = mixed(ThinDielectricMaterial{eta, base_colour(pbr)});
    glass.is_rough = facets_of(pbr.roughness * mean_of(pbr.green), pbr.anisotropy).has_value();
    glass.colour = pbr.base;
    glass.has_texture = pbr.colour.has_value() || pbr.vertices.colours != nullptr;
    glass.volume = volume_of(material, scene_);
    look.material = mixed(DielectricMaterial{eta, roughness_of(pbr)});
    look.glass = glass;
    for (const char* name : {"KHR_materials_clearcoat", "KHR_materials_specular",
                             "KHR_materials_iridescence", "KHR_materials_sheen"})
        if (material.extension(name))
            scene_.warnings.add(material.where(), std::string(name) + " is left out on glass");
    return true;
}

/// Adds what alpha leaves of the surface.
void GltfMaterials::add_alpha(const JsonPlace& material, const GltfPbr& pbr, GltfLook& look) {
    const std::string mode = material.text("alphaMode", "OPAQUE");
    if (mode == "OPAQUE") return;
    if (mode != "MASK" && mode != "BLEND")
        material.at("alphaMode").refuse("is no mode of alpha", "write OPAQUE, MASK or BLEND");
    const FloatTexture alpha = alpha_of(pbr);
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

/// A black surface that emits its base colour, 1 cd/m2 where that is 1, on both sides.
GltfLook GltfMaterials::made_unlit(const JsonPlace& material, const GltfPbr& pbr) {
    GltfLook look;
    look.material =
        GltfSurface(scene_, textures_, coats_, {}).add(DiffuseMaterial{Spectrum::constant(0)});
    AreaEmission emission;
    emission.two_sided = true;
    constexpr auto kNit = static_cast<float>(1 / kLumensPerWatt);
    emission.radiance = Spectrum::rgb_illuminant(Vec3(pbr.base)).scaled(kNit);
    if (pbr.colour) {
        emission.image = std::make_shared<const SurfaceImage>(
            coloured(pbr.colour->image.image, pbr.base)->with_channels(3));
        emission.radiance = Spectrum::d65().scaled(kNit);
    }
    if (pbr.vertices.colours)
        scene_.warnings.add(material.where(), "colours of vertices are left out where unlit");
    if (is_positive(pbr.base)) look.emission = std::move(emission);
    add_alpha(material, pbr, look);
    return look;
}

GltfLook GltfMaterials::made(const std::optional<JsonPlace>& material,
                             const GltfVertices& vertices) {
    const GltfPbr pbr = pbr_of(material, textures_, vertices);
    if (material && material->extension("KHR_materials_unlit")) return made_unlit(*material, pbr);
    GltfLook look;
    const BumpMap bump_map = material ? normal_map_of(*material, vertices) : BumpMap();
    GltfSurface surface(scene_, textures_, coats_, bump_map);
    const bool is_glass = material && add_glass(*material, pbr, surface, look);
    if (!is_glass) look.material = surface.add_opaque(pbr, material);
    if (!material) return look;
    if (!is_glass) warn_of_scattering_left_out(*material, scene_);
    add_emission(*material, vertices, look);
    add_alpha(*material, pbr, look);
    if (const auto e = material->extension("KHR_materials_anisotropy"); e && pbr.anisotropy > 0) {
        if (pbr.direction)
            scene_.warnings.add(
                pbr.direction->place.where(),
                "this texture gives the strength of anisotropy alone, no direction");
        look.tangent_turn = e->number("anisotropyRotation", 0);
        if (look.tangent_turn != 0 && !is_flat(bump_map)) {
            scene_.warnings.add(e->where(), "anisotropy is not rotated under a normal map");
            look.tangent_turn = 0;
        }
    }
    return look;
}

}  // namespace sunfleck::engine
