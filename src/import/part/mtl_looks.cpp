// Words of MTL as parameters of materials.
#include "import/part/mtl_looks.h"

#include "core/printable.h"
#include "light/surface_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kUsualIndex = 1.5;
constexpr double kLeastIndex = 1.001;  // of glass
constexpr double kMostIndex = 10;

double luminance(const Vec3d& rgb) {
    return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

double squared(double x) {
    return x * x;
}

class LookMaker {
public:
    LookMaker(const MtlMaterial& material, const PartLibrary& library, PartPictures& pictures,
              SceneDescription& scene)
        : m_(material), library_(library), pictures_(pictures), scene_(scene) {}

    PartLook make() {
        bump_map_ = pictures_.normals(m_.map("norm"), library_.path);
        if (is_flat(bump_map_))
            bump_map_ = pictures_.normals_in_place_of_heights(bump(), library_.path);
        PartLook look;
        if (is_glass()) {
            set_glass(look);
        } else {
            look.material = add(opaque());
            set_alpha(look);
        }
        look.emission = emission();
        warn_of_rest();
        return look;
    }

private:
    double number(std::string_view word, double otherwise) const {
        return m_.number(word).value_or(otherwise);
    }
    Vec3d colour(std::string_view word, const Vec3d& otherwise) const {
        return m_.colour(word).value_or(otherwise);
    }
    void warn(const std::string& what) { scene_.warnings.add(m_.where, what); }
    std::uint32_t add(Material material) {
        return add_material(scene_, std::move(material), bump_map_);
    }

    const MtlMap* bump() const {
        const MtlMap* const map = m_.map("map_bump");
        return map != nullptr ? map : m_.map("bump");
    }

    int model() const { return static_cast<int>(std::clamp(number("illum", -1), -1.0, 11.0)); }

    /// What covers: d, or 1 - Tr. Some writers have both, and the same number for both.
    double dissolve() const {
        if (const auto d = m_.number("d")) return *d;
        return 1 - number("tr", 0);
    }

    /// The models of refraction, where there is something to refract: some writers give them to all
    /// materials, and Ni 1 to those of opaque ones.
    bool is_glass() const {
        const int illum = model();
        if (illum != 4 && illum != 6 && illum != 7 && illum != 9) return false;
        if (const auto index = m_.number("ni")) return *index > kLeastIndex && *index < kMostIndex;
        return dissolve() < 1;
    }

    void set_glass(PartLook& look) {
        const Spectrum eta = Spectrum::constant(static_cast<float>(number("ni", kUsualIndex)));
        const double rough = std::clamp(number("pr", 0), 0.0, 1.0);
        const auto alpha = static_cast<float>(rough * rough);
        look.material = add(DielectricMaterial{eta, {alpha, alpha, false, true}});
        PartLook::Glass glass;
        glass.filter = colour("tf", Vec3d(1));
        if (glass.filter == Vec3d(0)) {
            warn("a filter (Tf) of glass that lets nothing pass is left out");
            glass.filter = Vec3d(1);
        }
        glass.pane = add(ThinDielectricMaterial{eta, Spectrum::rgb_albedo(Vec3(glass.filter))});
        look.glass = glass;
    }

    /// Returns the GGX alpha: of Pr its square; of Phong's exponent Ns the root of 2 / (Ns + 2)
    /// (Walter et al. 2007). Blender writes Ns as 1000 (1 - roughness)^2.
    double alpha() const {
        constexpr double kUsualRoughness = 0.5;
        constexpr double kOfBlender = 1000;
        double rough = kUsualRoughness;
        if (const auto stated = m_.number("pr")) {
            rough = *stated;
        } else if (const auto exponent = m_.number("ns")) {
            const double ns = std::max(*exponent, 0.0);
            if (!library_.materials.is_of_blender) return std::sqrt(2 / (ns + 2));
            rough = 1 - std::sqrt(ns / kOfBlender);
        }
        return squared(std::clamp(rough, 0.0, 1.0));
    }

    /// Returns roughness with its map, whose square is the alpha.
    Roughness roughness() {
        if (const auto map = pictures_.number(m_.map("map_pr"), library_.path)) {
            const FloatTexture square(FloatKind{ScaledKind<FloatTexture>{*map, *map}});
            return {square, square, false, true};
        }
        const auto a = static_cast<float>(alpha());
        return {a, a, false, true};
    }

    SpectrumTexture base() {
        const Vec3d kd = colour("kd", Vec3d(0.8));
        // Writers with a map have black beside it, where the map alone is meant.
        const Vec3d factor = kd == Vec3d(0) ? Vec3d(1) : kd;
        if (auto map = pictures_.colour(m_.map("map_kd"), factor, library_.path)) return *map;
        return Spectrum::rgb_albedo(Vec3(kd));
    }

    std::shared_ptr<const Coat> coat(double alpha) const {
        const double stated = number("ni", kUsualIndex);
        const double index = stated > kLeastIndex && stated < 3 ? stated : kUsualIndex;
        const auto a = static_cast<float>(alpha);
        std::optional<Ggx> facets;
        if (a >= kSmoothAlpha) facets = Ggx{a, a};
        return std::make_shared<const Coat>(static_cast<float>(index), facets, 0.0F);
    }

    Material plastic() {
        CoatedDiffuseMaterial plastic;
        plastic.reflectance = base();
        plastic.coat = coat(alpha());
        plastic.whole = true;
        if (m_.map("map_pr") != nullptr)
            warn("what is not metal has no map of roughness: map_Pr is left out");
        return plastic;
    }

    Material metal(const SpectrumTexture& reflectance) {
        ConductorMaterial metal;
        metal.reflectance = reflectance;
        metal.roughness = roughness();
        if (!(number("pc", 0) > 0)) return metal;
        metal.roughness.gives_back = false;
        return CoatedConductorMaterial{metal,
                                       coat(squared(std::clamp(number("pcr", 0), 0.0, 1.0)))};
    }

    bool has_metalness() const {
        for (const std::string_view word : {"pr", "pm"})
            if (m_.number(word)) return true;
        return m_.map("map_pr") != nullptr || m_.map("map_pm") != nullptr;
    }

    Material opaque() {
        if (has_metalness()) return by_metalness();
        constexpr double kBlack = 0.03;
        constexpr double kBright = 0.2;
        const double kd = m_.map("map_kd") == nullptr ? luminance(colour("kd", Vec3d(0.8))) : 1;
        const Vec3d ks = colour("ks", Vec3d(0));
        const int illum = model();
        if (kd < kBlack && luminance(ks) > kBright && illum != 0 && illum != 1)
            return metal(Spectrum::rgb_albedo(Vec3(ks)));
        const bool shines = luminance(ks) > 0 && illum != 0 && illum != 1;
        if (shines) return plastic();
        return DiffuseMaterial{base()};
    }

    Material by_metalness() {
        const auto map = pictures_.number(m_.map("map_pm"), library_.path);
        const FloatTexture amount =
            map ? *map : FloatTexture(static_cast<float>(std::clamp(number("pm", 0), 0.0, 1.0)));
        if (amount.is_constant() && amount.constant() == 1) return metal(base());
        if (amount.is_constant() && amount.constant() == 0) return plastic();
        const std::uint32_t first = add(plastic());
        const std::uint32_t second = add(metal(base()));
        return MixMaterial{{first, second}, amount};
    }

    void set_alpha(PartLook& look) {
        const double d = dissolve();
        if (d <= 0)
            warn("would be invisible (d 0 or Tr 1): it is opaque, as other writers mean it");
        const auto map = pictures_.number(m_.map("map_d"), library_.path);
        const auto factor = static_cast<float>(d <= 0 ? 1 : std::min(d, 1.0));
        if (!map && factor == 1) return;
        FloatTexture alpha = factor;
        if (map) alpha = FloatTexture(FloatKind{ScaledKind<FloatTexture>{*map, factor}});
        if (!map)
            warn("covers in part (d, Tr): light passes straight; glass has illum 7 and Ni 1.5");
        look.cover = cover_by(alpha);
        look.alpha = alpha;
    }

    std::optional<AreaEmission> emission() {
        const MtlMap* const map = m_.map("map_ke");
        const Vec3d ke = colour("ke", Vec3d(map != nullptr ? 1 : 0));
        constexpr double kMost = 1e30;
        if (!(std::max({ke.x, ke.y, ke.z}) > 0)) return {};
        AreaEmission light;
        constexpr auto kScale = static_cast<float>(1 / kLumensPerWatt);
        light.radiance =
            Spectrum::rgb_illuminant(
                Vec3(Vec3d(std::min(ke.x, kMost), std::min(ke.y, kMost), std::min(ke.z, kMost))))
                .scaled(kScale);
        if (const auto image = pictures_.light(map, ke, library_.path)) {
            light.image = std::make_shared<const SurfaceImage>(image->with_channels(3));
            light.radiance = Spectrum::d65().scaled(kScale);
        }
        return light;
    }

    void warn_of_rest() {
        static constexpr std::array kLeftOut = {"map_ks", "map_ns", "map_tr",   "disp",
                                                "decal",  "refl",   "map_refl", "map_disp",
                                                "map_ps", "map_tf", "map_ni"};
        for (const char* const word : kLeftOut)
            if (m_.map(word) != nullptr) warn(in_quotes(word) + " is left out");
        for (const char* const word : {"ps", "aniso"})
            if (number(word, 0) != 0) warn(in_quotes(word) + " is left out");
    }

    const MtlMaterial& m_;
    const PartLibrary& library_;
    PartPictures& pictures_;
    SceneDescription& scene_;
    BumpMap bump_map_;
};

}  // namespace

PartLook look_of(const MtlMaterial& material, const PartLibrary& library, PartPictures& pictures,
                 SceneDescription& scene) {
    return LookMaker(material, library, pictures, scene).make();
}

}  // namespace sunfleck::engine
