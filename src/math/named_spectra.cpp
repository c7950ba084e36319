// The spectra that pbrt-v4 knows by name: illuminants, glasses, metals.
#include "math/colour.h"
#include "math/data_glass.h"
#include "math/data_illuminants.h"
#include "math/data_metals.h"
#include "math/spectrum.h"

#include <map>
#include <span>

namespace sunfleck::engine {

namespace {

namespace data = spectra_data;

using Points = std::vector<TabulatedSpectrum::Point>;
using Spectra = std::map<std::string, Spectrum>;

/// As pbrt-v4 has it: the first and last value hold to the ends of the visible range.
Spectrum extended_table(Points points) {
    if (points.front().nm > kFirstNm)
        points.insert(points.begin(), {kFirstNm - 1, points[0].value});
    if (points.back().nm < kLastNm) points.push_back({kLastNm + 1, points.back().value});
    return Spectrum::table(std::move(points));
}

Spectrum tabulated(std::span<const double> nm, std::span<const double> values) {
    Points points;
    for (std::size_t i = 0; i < nm.size(); ++i)
        points.push_back({static_cast<float>(nm[i]), static_cast<float>(values[i])});
    return extended_table(std::move(points));
}

/// An illuminant given every 5 nm from `first` on, scaled to luminance one.
Spectrum illuminant(float first, std::span<const double> values) {
    Points points;
    for (const double value : values)
        points.push_back(
            {first + 5 * static_cast<float>(points.size()), static_cast<float>(value)});
    const float luminance = extended_table(points).luminance();
    for (auto& point : points) point.value /= luminance;
    return extended_table(std::move(points));
}

void add_illuminants(Spectra& all) {
    all.emplace("stdillum-A", illuminant(300, data::kIlluminantA));
    all.emplace("stdillum-D50", illuminant(300, data::kIlluminantD50));
    all.emplace("stdillum-D65", illuminant(300, data::kIlluminantD65));
    all.emplace("illum-acesD60", illuminant(300, data::kIlluminantAcesD60));
    all.emplace("stdillum-F1", illuminant(380, data::kIlluminantF1));
    all.emplace("stdillum-F2", illuminant(380, data::kIlluminantF2));
    all.emplace("stdillum-F3", illuminant(380, data::kIlluminantF3));
    all.emplace("stdillum-F4", illuminant(380, data::kIlluminantF4));
    all.emplace("stdillum-F5", illuminant(380, data::kIlluminantF5));
    all.emplace("stdillum-F6", illuminant(380, data::kIlluminantF6));
    all.emplace("stdillum-F7", illuminant(380, data::kIlluminantF7));
    all.emplace("stdillum-F8", illuminant(380, data::kIlluminantF8));
    all.emplace("stdillum-F9", illuminant(380, data::kIlluminantF9));
    all.emplace("stdillum-F10", illuminant(380, data::kIlluminantF10));
    all.emplace("stdillum-F11", illuminant(380, data::kIlluminantF11));
    all.emplace("stdillum-F12", illuminant(380, data::kIlluminantF12));
}

/// pbrt-v4's glass-F5, -F10 and -F11 are Schott's SF5, SF10 and SF11.
void add_glasses(Spectra& all) {
    all.emplace("glass-BK7", tabulated(data::kBK7Nm, data::kBK7Eta));
    all.emplace("glass-BAF10", tabulated(data::kBAF10Nm, data::kBAF10Eta));
    all.emplace("glass-FK51A", tabulated(data::kFK51ANm, data::kFK51AEta));
    all.emplace("glass-LASF9", tabulated(data::kLASF9Nm, data::kLASF9Eta));
    all.emplace("glass-F5", tabulated(data::kSF5Nm, data::kSF5Eta));
    all.emplace("glass-F10", tabulated(data::kSF10Nm, data::kSF10Eta));
    all.emplace("glass-F11", tabulated(data::kSF11Nm, data::kSF11Eta));
}

void add_metals(Spectra& all) {
    all.emplace("metal-Ag-eta", tabulated(data::kAgNm, data::kAgEta));
    all.emplace("metal-Ag-k", tabulated(data::kAgNm, data::kAgK));
    all.emplace("metal-Al-eta", tabulated(data::kAgNm, data::kAlEta));
    all.emplace("metal-Al-k", tabulated(data::kAgNm, data::kAlK));
    all.emplace("metal-Au-eta", tabulated(data::kAgNm, data::kAuEta));
    all.emplace("metal-Au-k", tabulated(data::kAgNm, data::kAuK));
    all.emplace("metal-Cu-eta", tabulated(data::kAgNm, data::kCuEta));
    all.emplace("metal-Cu-k", tabulated(data::kAgNm, data::kCuK));
    all.emplace("metal-CuZn-eta", tabulated(data::kCuZnNm, data::kCuZnEta));
    all.emplace("metal-CuZn-k", tabulated(data::kCuZnNm, data::kCuZnK));
    all.emplace("metal-MgO-eta", tabulated(data::kMgONm, data::kMgOEta));
    all.emplace("metal-MgO-k", tabulated(data::kMgONm, data::kMgOK));
    all.emplace("metal-TiO2-eta", tabulated(data::kTiO2Nm, data::kTiO2Eta));
    all.emplace("metal-TiO2-k", tabulated(data::kTiO2Nm, data::kTiO2K));
}

const Spectra& spectra() {
    static const Spectra all = [] {
        Spectra built;
        add_illuminants(built);
        add_glasses(built);
        add_metals(built);
        return built;
    }();
    return all;
}

}  // namespace

std::optional<Spectrum> named_spectrum(const std::string& name) {
    const auto found = spectra().find(name);
    if (found == spectra().end()) return std::nullopt;
    return found->second;
}

std::vector<std::string> named_spectra() {
    std::vector<std::string> names;
    for (const auto& [name, curve] : spectra()) names.push_back(name);
    return names;
}

}  // namespace sunfleck::engine
