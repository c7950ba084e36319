// Means over a measured material.
#include "import/pbrt/measured.h"

#include "import/pbrt/tensor_file.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr float kHalfPi = kPi / 2;

/// Of the trapezoidal rule over [0,1], or of a single point.
float weight_at(std::size_t i, std::size_t count) {
    if (count == 1) return 1;
    const float inner = 1 / static_cast<float>(count - 1);
    return i == 0 || i + 1 == count ? inner / 2 : inner;
}

/// Of each angle of incidence, of evenly spread light: by steps of sin^2 around them.
std::vector<float> weights_of(const std::vector<float>& angles) {
    std::vector<float> places;
    for (const float angle : angles) {
        const float sine = std::sin(std::clamp(angle, 0.0F, kHalfPi));
        places.push_back(std::max(sine * sine, places.empty() ? 0 : places.back()));
    }
    std::vector<float> weights;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const float low = i == 0 ? 0 : (places[i - 1] + places[i]) / 2;
        const float high = i + 1 == places.size() ? 1 : (places[i] + places[i + 1]) / 2;
        weights.push_back(high - low);
    }
    return weights;
}

/// @param spectra  by azimuth and angle of incidence, wavelength, and both numbers u.
std::vector<float> albedo_of(const Tensor& spectra, const std::vector<float>& of_angles) {
    const auto& n = spectra.extents;
    std::vector<float> albedo(n[2], 0);
    const float* value = spectra.values.data();
    for (std::size_t phi = 0; phi < n[0]; ++phi)
        for (std::size_t theta = 0; theta < n[1]; ++theta)
            for (std::size_t colour = 0; colour < n[2]; ++colour) {
                float mean = 0;
                for (std::size_t i = 0; i < n[3]; ++i)
                    for (std::size_t j = 0; j < n[4]; ++j)
                        mean += *value++ * weight_at(i, n[3]) * weight_at(j, n[4]);
                albedo[colour] +=
                    std::max(mean, 0.0F) * of_angles[theta] / static_cast<float>(n[0]);
            }
    return albedo;
}

/// Half of the facets, by the area that they cover, are tilted less than this: its tangent.
/// (Of GGX that is alpha.) @param facets  density by azimuth and sqrt(2 / pi * tilt).
float median_slope(const Tensor& facets) {
    const std::size_t tilts = facets.extents[1];
    std::vector<float> covered(tilts, 0);  // up to each tilt
    float sum = 0;
    for (std::size_t j = 0; j < tilts; ++j) {
        const float u = tilts > 1 ? static_cast<float>(j) / static_cast<float>(tilts - 1) : 0;
        const float tilt = u * u * kHalfPi;
        float density = 0;
        for (std::size_t i = 0; i < facets.extents[0]; ++i)
            density += std::max(facets.values[i * tilts + j], 0.0F);
        covered[j] = sum += density * std::sin(tilt) * std::cos(tilt) * u;  // d tilt ~ u du
    }
    const auto middle = std::lower_bound(covered.begin(), covered.end(), sum / 2);
    if (!(sum > 0) || tilts < 2) return 1;
    const float u = static_cast<float>(middle - covered.begin()) / static_cast<float>(tilts - 1);
    return std::tan(std::min(u * u * kHalfPi, 1.5F));
}

}  // namespace

MeasuredSummary summary_of_measured(const std::string& bytes, const SourceLocation& from) {
    const auto tensors =
        read_tensors(bytes, {{"theta_i", 1}, {"wavelengths", 1}, {"ndf", 2}, {"spectra", 5}}, from);
    const Tensor& spectra = tensors.at("spectra");
    const std::vector<float>& wavelengths = tensors.at("wavelengths").values;
    const std::vector<float>& angles = tensors.at("theta_i").values;
    const bool rises = std::adjacent_find(wavelengths.begin(), wavelengths.end(),
                                          std::greater_equal<>()) == wavelengths.end();
    if (!rises || spectra.extents[1] != angles.size() || spectra.extents[2] != wavelengths.size())
        throw Error(from, "the file of measurements has spectra of another shape than its axes",
                    "get the file again");
    const std::vector<float> albedo = albedo_of(spectra, weights_of(angles));
    std::vector<TabulatedSpectrum::Point> points;
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
        points.push_back({wavelengths[i], std::min(albedo[i], 1.0F)});
    return {Spectrum::table(std::move(points)), median_slope(tensors.at("ndf"))};
}

}  // namespace sunfleck::engine
