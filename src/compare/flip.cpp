// FLIP from its parts: filtered colours, features, and how both make one number.
#include "compare/flip.h"

#include "compare/flip_colour.h"
#include "compare/flip_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

using flip::Plane;

// Names as in the paper: q_c, p_c, p_t, q_f.
constexpr float kColourExponent = 0.7F;
constexpr float kSmallShare = 0.4F;
constexpr float kSmallRange = 0.95F;
constexpr float kFeatureExponent = 0.5F;

/// The ACES curve: (a x^2 + b x) / (c x^2 + d x + e), with its pre-exposure of 0.6 taken out.
struct Aces {
    static constexpr float kA = 0.6F * 0.6F * 2.51F;
    static constexpr float kB = 0.6F * 0.03F;
    static constexpr float kC = 0.6F * 0.6F * 2.43F;
    static constexpr float kD = 0.6F * 0.59F;
    static constexpr float kE = 0.14F;

    static float curve(float x) {
        x = std::max(x, 0.0F);
        if (x > 1e9F) return 1;  // and its squares do not overflow
        return std::min((kA * x * x + kB * x) / (kC * x * x + kD * x + kE), 1.0F);
    }
    /// Where the curve is y; y below its limit.
    static float inverse(float y) {
        const float half = -0.5F * (kB - y * kD) / (kA - y * kC);
        return half + std::sqrt(half * half + y * kE / (kA - y * kC));
    }
};

/// What of one picture goes into the difference.
struct Seen {
    std::vector<Vec3> lab;     // filtered as the eye does
    std::vector<Vec2> edges;   // gradient of the unfiltered luminance
    std::vector<Vec2> points;  // its second derivatives
};

/// The opponent channels, each a plane.
std::array<Plane, 3> opponent_planes(const RgbImage& image) {
    std::array<Plane, 3> planes;
    for (Plane& plane : planes)
        plane = {image.width, image.height, std::vector<float>(image.pixels.size())};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Vec3 ycc = flip::opponent_of_rgb(image.pixels[i]);
        for (int c = 0; c < 3; ++c) planes[static_cast<std::size_t>(c)].values[i] = ycc[c];
    }
    return planes;
}

Plane filtered(const Plane& plane, std::size_t channel, float pixels_per_degree) {
    Plane all{plane.width, plane.height, std::vector<float>(plane.values.size())};
    for (const flip::Kernel& kernel : flip::contrast_kernels(channel, pixels_per_degree)) {
        const Plane part = flip::convolve(plane, kernel, kernel);
        for (std::size_t i = 0; i < all.values.size(); ++i) all.values[i] += part.values[i];
    }
    return all;
}

std::vector<Vec2> derivatives(const Plane& plane, const flip::Kernel& derivative,
                              const flip::Kernel& gaussian) {
    const Plane x = flip::convolve(plane, derivative, gaussian);
    const Plane y = flip::convolve(plane, gaussian, derivative);
    std::vector<Vec2> both(x.values.size());
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = Vec2(x.values[i], y.values[i]);
    return both;
}

/// @param image  within [0,1].
Seen seen(const RgbImage& image, float pixels_per_degree) {
    std::array<Plane, 3> planes = opponent_planes(image);
    Plane luminance = planes[0];
    for (float& value : luminance.values) value = (value + 16) / 116;
    const flip::FeatureKernels kernels = flip::feature_kernels(pixels_per_degree);
    Seen result;
    result.edges = derivatives(luminance, kernels.first, kernels.gaussian);
    result.points = derivatives(luminance, kernels.second, kernels.gaussian);
    for (std::size_t c = 0; c < 3; ++c) planes[c] = filtered(planes[c], c, pixels_per_degree);
    result.lab.reserve(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Vec3 ycc(planes[0].values[i], planes[1].values[i], planes[2].values[i]);
        result.lab.push_back(flip::hunt_lab(flip::clamp01(flip::rgb_of_opponent(ycc))));
    }
    return result;
}

/// Section 4.2: small differences get most of [0,1], large ones the rest.
float colour_difference(const Vec3& a, const Vec3& b) {
    static const float largest =
        std::pow(flip::hyab(flip::hunt_lab({0, 1, 0}), flip::hunt_lab({0, 0, 1})), kColourExponent);
    const float difference = std::pow(flip::hyab(a, b), kColourExponent);
    const float knee = kSmallShare * largest;
    if (difference < knee) return kSmallRange / knee * difference;
    return kSmallRange + (difference - knee) / (largest - knee) * (1 - kSmallRange);
}

/// Section 4.3.
float feature_difference(const Seen& a, const Seen& b, std::size_t i) {
    const float edges = std::abs(a.edges[i].length() - b.edges[i].length());
    const float points = std::abs(a.points[i].length() - b.points[i].length());
    return std::pow(std::sqrt(0.5F) * std::max(edges, points), kFeatureExponent);
}

/// @param reference, test  within [0,1].
std::vector<float> flip_of(const RgbImage& reference, const RgbImage& test,
                           float pixels_per_degree) {
    const Seen a = seen(reference, pixels_per_degree);
    const Seen b = seen(test, pixels_per_degree);
    std::vector<float> map(reference.pixels.size());
    for (std::size_t i = 0; i < map.size(); ++i)
        map[i] = std::pow(std::min(colour_difference(a.lab[i], b.lab[i]), 1.0F),
                          1 - feature_difference(a, b, i));
    return map;
}

template <class Curve>
RgbImage mapped(const RgbImage& image, const Curve& curve) {
    RgbImage out{image.width, image.height, {}};
    out.pixels.reserve(image.pixels.size());
    for (const Vec3& p : image.pixels) out.pixels.emplace_back(curve(p.x), curve(p.y), curve(p.z));
    return out;
}

}  // namespace

std::vector<float> ldr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree) {
    const auto cut = [](float x) { return std::clamp(x, 0.0F, 1.0F); };
    return flip_of(mapped(reference, cut), mapped(test, cut), pixels_per_degree);
}

std::vector<float> hdr_exposures(const RgbImage& reference) {
    std::vector<float> lights;
    for (const Vec3& pixel : reference.pixels) lights.push_back(luminance(pixel));
    std::sort(lights.begin(), lights.end());
    const auto lit = std::upper_bound(lights.begin(), lights.end(), 0.0F);
    if (lit == lights.end()) return {};
    float median = lights[lights.size() / 2];
    if (!(median > 0)) median = *(lit + (lights.end() - lit) / 2);
    const float limit = Aces::inverse(0.85F);
    const float start = std::log2(limit / lights.back());
    const float stop = std::log2(limit / median);
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    std::vector<float> exposures;
    exposures.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        exposures.push_back(start +
                            static_cast<float>(i) * (stop - start) / static_cast<float>(count - 1));
    return exposures;
}

std::vector<float> hdr_flip(const RgbImage& reference, const RgbImage& test,
                            float pixels_per_degree) {
    std::vector<float> greatest;
    for (const float exposure : hdr_exposures(reference)) {
        const float factor = std::exp2(exposure);
        const auto shown = [&](float x) { return Aces::curve(factor * x); };
        const std::vector<float> map =
            flip_of(mapped(reference, shown), mapped(test, shown), pixels_per_degree);
        greatest.resize(map.size());
        for (std::size_t i = 0; i < map.size(); ++i) greatest[i] = std::max(greatest[i], map[i]);
    }
    return greatest;
}

}  // namespace sunfleck::engine
