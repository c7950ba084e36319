// Materials from formulas and tables of refractive indices.
#include "material/substances.h"

#include "core/named_rows.h"
#include "material/data_indices.h"

#include <array>
#include <cmath>
#include <vector>

namespace sunfleck::engine {
namespace {

namespace data = index_data;

constexpr int kFirstTableNm = 360;
constexpr int kLastTableNm = 830;

template <class Value>
Spectrum every_5_nm(const Value& value) {
    std::vector<TabulatedSpectrum::Point> points;
    for (int nm = kFirstTableNm; nm <= kLastTableNm; nm += 5)
        points.push_back({static_cast<float>(nm), static_cast<float>(value(nm))});
    return Spectrum::table(std::move(points));
}

Spectrum index_by(const data::Sellmeier& formula) {
    return every_5_nm([&](int nm) {
        const double w2 = 1e-6 * nm * nm;  // squared micrometres
        double n2 = 1;
        for (const auto& term : formula.terms) n2 += term.b * w2 / (w2 - term.c);
        return std::sqrt(n2);
    });
}

Spectrum index_of_soda_lime() {
    return every_5_nm([](int nm) {
        const double w2 = 1e-6 * nm * nm;
        return data::kSodaLime[0] + data::kSodaLime[1] * w2 + data::kSodaLime[2] / w2;
    });
}

/// Returns a column of a table over its wavelengths.
template <std::size_t Columns, std::size_t Rows>
std::vector<TabulatedSpectrum::Point> column(
    const std::array<std::array<double, Columns>, Rows>& table, std::size_t number) {
    std::vector<TabulatedSpectrum::Point> points;
    points.reserve(Rows);
    for (const auto& row : table)
        points.push_back({static_cast<float>(row[0]), static_cast<float>(row.at(number))});
    return points;
}

/// Returns 4 pi k / wavelength, per metre.
template <std::size_t Rows>
Spectrum absorption_by(const std::array<std::array<double, 2>, Rows>& k) {
    auto points = column(k, 1);
    for (auto& point : points) point.value *= 4 * kPi / (1e-9F * point.nm);
    return Spectrum::table(std::move(points));
}

std::optional<Spectrum> formula_index(std::string_view name) {
    struct Row {
        std::string_view name;
        const data::Sellmeier* formula;
    };
    static constexpr auto kRows = std::to_array<Row>({{"f2", &data::kF2},
                                                      {"fused-silica", &data::kFusedSilica},
                                                      {"fluorite", &data::kFluorite},
                                                      {"sapphire", &data::kSapphire},
                                                      {"diamond", &data::kDiamond},
                                                      {"water", &data::kWater},
                                                      {"pmma", &data::kPmma},
                                                      {"polycarbonate", &data::kPolycarbonate},
                                                      {"polystyrene", &data::kPolystyrene}});
    const Row* const row = row_named(kRows, name);
    if (row == nullptr) return {};
    return index_by(*row->formula);
}

struct PbrtRow {
    std::string_view name;
    std::string_view pbrt;
};

/// Returns pbrt-v4's name of a glass or metal, or nothing.
std::string_view pbrt_name(std::string_view name) {
    static constexpr auto kRows = std::to_array<PbrtRow>({{"bk7", "glass-BK7"},
                                                          {"baf10", "glass-BAF10"},
                                                          {"fk51a", "glass-FK51A"},
                                                          {"lasf9", "glass-LASF9"},
                                                          {"sf5", "glass-F5"},
                                                          {"sf10", "glass-F10"},
                                                          {"sf11", "glass-F11"},
                                                          {"aluminium", "metal-Al"},
                                                          {"silver", "metal-Ag"},
                                                          {"gold", "metal-Au"},
                                                          {"copper", "metal-Cu"},
                                                          {"brass", "metal-CuZn"}});
    const PbrtRow* const row = row_named(kRows, name);
    return row == nullptr ? std::string_view() : row->pbrt;
}

Roughness roughness_of(const MaterialWishes& wishes) {
    const float r = wishes.roughness.value_or(0);
    return {r * r, r * r, false, true};
}

NamedMaterial glass_of(const MaterialName& row, const MaterialWishes& wishes) {
    NamedMaterial glass;
    glass.is_clear = true;
    Spectrum eta;
    if (row.name == "soda-lime")
        eta = index_of_soda_lime();
    else if (const auto by_formula = formula_index(row.name))
        eta = *by_formula;
    else
        eta = named_spectrum(std::string(pbrt_name(row.name))).value();
    if (row.name == "soda-lime") glass.absorption = absorption_by(data::kSodaLimeK);
    if (row.name == "water") glass.absorption = absorption_by(data::kWaterK);
    glass.material = DielectricMaterial{eta, roughness_of(wishes)};
    return glass;
}

template <std::size_t Rows>
void set_indices(ConductorMaterial& metal, const std::array<std::array<double, 3>, Rows>& table) {
    metal.eta = Spectrum::table(column(table, 1));
    metal.k = Spectrum::table(column(table, 2));
}

NamedMaterial metal_of(const MaterialName& row, const MaterialWishes& wishes) {
    constexpr float kMirror = 0.95F;
    ConductorMaterial metal;
    metal.roughness = roughness_of(wishes);
    const std::string pbrt(pbrt_name(row.name));
    if (row.name == "mirror") {
        metal.reflectance = Spectrum::constant(kMirror);
    } else if (row.name == "iron") {
        set_indices(metal, data::kIron);
    } else if (row.name == "chromium") {
        set_indices(metal, data::kChromium);
    } else if (row.name == "titanium") {
        set_indices(metal, data::kTitanium);
    } else {
        metal.eta = named_spectrum(pbrt + "-eta").value();
        metal.k = named_spectrum(pbrt + "-k").value();
    }
    return {metal};
}

struct PlasticRow {
    std::string_view name;
    float grey;
    float roughness;
};

NamedMaterial plastic_of(const MaterialName& row, const MaterialWishes& wishes) {
    static constexpr auto kRows = std::to_array<PlasticRow>(
        {{"plastic", 0.6F, 0.3F}, {"rubber", 0.03F, 0.6F}, {"lacquer", 0.3F, 0}});
    constexpr float kIndex = 1.5F;
    const PlasticRow& usual = *row_named(kRows, row.name);
    const float r = wishes.roughness.value_or(usual.roughness);
    std::optional<Ggx> facets;
    if (r * r >= kSmoothAlpha) facets = Ggx{r * r, r * r};
    CoatedDiffuseMaterial plastic;
    plastic.reflectance = Spectrum::rgb_albedo(wishes.colour.value_or(Vec3(usual.grey)));
    plastic.coat = std::make_shared<const Coat>(kIndex, facets, 0.0F);
    plastic.whole = true;
    return {plastic};
}

NamedMaterial matt_of(const MaterialName& row, const MaterialWishes& wishes) {
    Vec3 rgb(0.6F);
    if (row.name == "plaster") rgb = {0.8F, 0.77F, 0.72F};
    if (row.name == "paper") rgb = Vec3(0.85F);
    if (row.name == "clay") rgb = {0.47F, 0.21F, 0.12F};
    return {DiffuseMaterial{Spectrum::rgb_albedo(wishes.colour.value_or(rgb))}};
}

}  // namespace

NamedMaterial material_of(const MaterialName& row, const MaterialWishes& wishes) {
    switch (row.family) {
        case MaterialFamily::glass:
            return glass_of(row, wishes);
        case MaterialFamily::metal:
            return metal_of(row, wishes);
        case MaterialFamily::plastic:
            return plastic_of(row, wishes);
        case MaterialFamily::matt:
            return matt_of(row, wishes);
    }
    return matt_of(row, wishes);
}

}  // namespace sunfleck::engine
