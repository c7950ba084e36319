// Statistics from JSON, errors from pictures.
#include "experiment/results.h"

#include "core/statistics_file.h"
#include "experiment/methods.h"
#include "experiment/numbers.h"
#include "film/luminance.h"
#include "image/exr.h"
#include "sunfleck/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

double number(const nlohmann::json& json, const char* name) {
    return json.contains(name) && json[name].is_number() ? json[name].get<double>()
                                                         : CellFacts::kNone;
}

CellFacts read_facts(const fs::path& picture) {
    const auto path = fs::path(picture).replace_extension(".json").string();
    const auto json = nlohmann::json::parse(read_statistics_file(path), nullptr, false);
    if (!json.is_object())
        throw Error({path}, "holds no statistics of a render",
                    "remove its folder, to render again");
    CellFacts facts;
    facts.picture = picture.string();
    facts.passes = number(json, "passes");
    facts.seconds = number(json["seconds"], "total");
    facts.cpu_seconds = number(json, "cpu_seconds");
    facts.visible_fraction = number(json["visible_fraction"], "value");
    facts.visible_ratio = number(json, "visible_photon_ratio");
    facts.visible_ratio_with_repeats = number(json, "visible_photon_ratio_with_repeats");
    facts.mutation_size = number(json, "mutation_size");
    facts.acceptance = number(json, "acceptance");
    facts.mean = number(json["image"], "mean");
    return facts;
}

/// The mean without the hundredth of the largest, whatever their sign: where the reference is
/// noisy, a square less its variance may be far below zero.
double trimmed_mean(std::vector<double> values) {
    const std::size_t left_out = values.size() / 100;
    std::nth_element(values.begin(), values.end() - static_cast<std::ptrdiff_t>(left_out),
                     values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    values.resize(values.size() - left_out);
    return mean_of(values);
}

bool sees_lamp(const MeasuredPicture& picture, std::size_t pixel) {
    return !picture.sees_lamp.empty() && picture.sees_lamp[pixel];
}

double own_error(const Reference& r) {
    if (r.variance.empty()) return CellFacts::kNone;
    double sum = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < r.variance.size(); ++i) {
        if (sees_lamp(r.picture, i)) continue;
        const double value = r.picture.luminance[i];
        sum += r.variance[i] / (value * value + 0.01 * r.mean * r.mean);
        ++counted;
    }
    return sum / static_cast<double>(counted);
}

std::vector<double> square_of_errors(const Picture& picture) {
    std::vector<double> squares;
    if (const Channel* error = picture.find("error.Y"))
        for (const float e : error->values) squares.push_back(static_cast<double>(e) * e);
    return squares;
}

std::vector<double> luminance_of(const Picture& picture, const std::string& name) {
    const Channel* const r = picture.find("R");
    const Channel* const g = picture.find("G");
    const Channel* const b = picture.find("B");
    if (r == nullptr || g == nullptr || b == nullptr)
        throw Error({name}, "has no channels R, G and B", "give a picture in colour");
    std::vector<double> by_pixel(picture.pixels());
    for (std::size_t i = 0; i < by_pixel.size(); ++i)
        by_pixel[i] =
            luminance(Triple{static_cast<double>(r->values[i]), static_cast<double>(g->values[i]),
                             static_cast<double>(b->values[i])});
    return by_pixel;
}

std::vector<bool> lamps_of(const Picture& picture) {
    const Channel* const red = picture.find("emission.R");
    const Channel* const green = picture.find("emission.G");
    const Channel* const blue = picture.find("emission.B");
    if (red == nullptr || green == nullptr || blue == nullptr) return {};
    std::vector<bool> seen(picture.pixels());
    for (std::size_t i = 0; i < seen.size(); ++i)
        seen[i] = red->values[i] != 0 || green->values[i] != 0 || blue->values[i] != 0;
    return seen;
}

MeasuredPicture measured_of(const Picture& picture, const std::string& name) {
    return {luminance_of(picture, name), lamps_of(picture)};
}

}  // namespace

MeasuredPicture read_measured(const std::string& exr) {
    return measured_of(read_exr(exr), exr);
}

std::vector<CellFacts> Results::snapshots(const Cell& cell) const {
    std::vector<fs::path> pictures;
    for (const auto& entry : fs::directory_iterator(store_.folder(cell)))
        if (entry.path().extension() == ".exr") pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    if (pictures.empty())
        throw Error({store_.folder(cell)}, "holds no picture", "remove it, to render again");
    std::vector<CellFacts> all;
    all.reserve(pictures.size());
    for (const fs::path& picture : pictures) all.push_back(read_facts(picture));
    return all;
}

const Reference& Results::reference(const std::string& scene) const {
    const auto found = references_.find(scene);
    if (found != references_.end()) return found->second;
    const Cell cell = reference_cell(scene, settings());
    const std::string file = facts(cell).picture;
    const Picture picture = read_exr(file);
    Reference r{cell.method.name, measured_of(picture, file), square_of_errors(picture), 0, 0};
    r.mean = mean_of(r.picture.luminance);
    r.own_rel_mse = own_error(r);
    return references_.emplace(scene, std::move(r)).first->second;
}

bool Results::has_reference(const std::string& scene) const {
    return store_.has(reference_cell(scene, settings()));
}

PictureError Results::error(const std::string& scene, const std::string& picture) const {
    const auto found = errors_.find(picture);
    if (found != errors_.end()) return found->second;
    return errors_.emplace(picture, measured(scene, picture)).first->second;
}

PictureError Results::measured(const std::string& scene, const std::string& picture) const {
    const Reference& r = reference(scene);
    const MeasuredPicture measured = read_measured(picture);
    if (measured.luminance.size() != r.picture.luminance.size())
        throw Error({picture}, "has another size than the reference of " + scene,
                    "render it at the size of this run");
    std::vector<double> squares;
    double rel_mse = 0;
    for (std::size_t i = 0; i < measured.luminance.size(); ++i) {
        if (sees_lamp(measured, i) || sees_lamp(r.picture, i)) continue;
        const double truth = r.picture.luminance[i];
        const double difference = measured.luminance[i] - truth;
        const double square = difference * difference - (r.variance.empty() ? 0 : r.variance[i]);
        squares.push_back(square / (r.mean * r.mean));
        rel_mse += square / (truth * truth + 0.01 * r.mean * r.mean);
    }
    return {mean_of(squares), rel_mse / static_cast<double>(squares.size()), trimmed_mean(squares)};
}

std::vector<Cell> Results::cells(const std::string& scene, const Method& method) const {
    std::vector<Cell> all;
    for (std::uint64_t seed = 1; seed <= settings().seeds; ++seed)
        all.push_back({scene, method, seed});
    return all;
}

std::vector<double> Results::errors(const std::string& scene, const Method& method,
                                    ErrorKind kind) const {
    std::vector<double> all;
    for (const Cell& cell : cells(scene, method)) all.push_back(error(cell).*kind);
    return all;
}

std::vector<double> Results::costs(const std::string& scene, const Method& method,
                                   ErrorKind kind) const {
    std::vector<double> all;
    for (const Cell& cell : cells(scene, method))
        all.push_back(error(cell).*kind * facts(cell).cpu_seconds);
    return all;
}

}  // namespace sunfleck::engine
