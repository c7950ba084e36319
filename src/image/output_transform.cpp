// The steps of the output transform.
#include "image/output_transform.h"

#include "core/parallel.h"
#include "image/glare.h"
#include "image/srgb.h"
#include "math/white_balance.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck::engine {
namespace {

using Planes = std::array<std::vector<float>, 3>;  // R, G, B

/// Returns the light of R, G, B times `scale`.
Planes exposed(const Picture& picture, float scale, const std::string& path) {
    constexpr std::array<const char*, 3> kNames = {"R", "G", "B"};
    Planes planes;
    for (std::size_t c = 0; c < planes.size(); ++c) {
        const Channel* channel = picture.find(kNames.at(c));
        if (channel == nullptr)
            throw Error({path}, "the picture has no channel " + std::string(kNames.at(c)),
                        "write it as .exr");
        planes.at(c) = channel->values;
        for (float& value : planes.at(c)) value *= scale;
    }
    return planes;
}

void scatter(Planes& planes, const Vec2i& size, double fraction, const std::string& path) {
    for (std::vector<float>& light : planes) {
        if (!std::all_of(light.begin(), light.end(), [](float v) { return std::isfinite(v); }))
            throw Error({path}, "glare cannot spread light that is not finite",
                        "leave --glare out, or lower --exposure");
        add_glare(light, size, fraction);
    }
}

/// Darkens by the fourth power of the cosine of the angle to the axis of a pinhole camera whose
/// corners lose `stops`.
void darken_corners(Planes& planes, const Vec2i& size, double stops) {
    const double tangent2 = std::exp2(stops / 2) - 1;  // of the angle of a corner, squared
    const double middle_x = 0.5 * size.x;
    const double middle_y = 0.5 * size.y;
    const double scale = tangent2 / (middle_x * middle_x + middle_y * middle_y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double dx = x + 0.5 - middle_x;
            const double dy = y + 0.5 - middle_y;
            const double secant2 = 1 + scale * (dx * dx + dy * dy);
            const auto factor = static_cast<float>(1 / (secant2 * secant2));
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                           static_cast<std::size_t>(x);
            for (std::vector<float>& light : planes) light[i] *= factor;
        }
}

/// Applies white balance and the tone curve to each pixel.
void colour(Planes& planes, const OutputTransform& transform) {
    const std::optional<Rows> balance = transform.white_balance
                                            ? std::optional(white_balance(*transform.white_balance))
                                            : std::nullopt;
    parallel_blocks(planes[0].size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3 light(planes[0][i], planes[1][i], planes[2][i]);
            if (balance) {
                const Triple rgb = *balance * Triple{light.x, light.y, light.z};
                light = Vec3(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]),
                             static_cast<float>(rgb[2]));
            }
            if (transform.tone != Tone::none) light = toned(transform.tone, light);
            for (int c = 0; c < 3; ++c) planes.at(static_cast<std::size_t>(c))[i] = light[c];
        }
    });
}

}  // namespace

std::vector<float> screen_values(const Picture& picture, const OutputTransform& transform,
                                 const std::string& path) {
    Planes planes = exposed(picture, std::exp2(transform.exposure), path);
    const Vec2i size(picture.width, picture.height);
    if (transform.glare > 0) scatter(planes, size, transform.glare, path);
    if (transform.vignette > 0) darken_corners(planes, size, transform.vignette);
    if (transform.white_balance || transform.tone != Tone::none) colour(planes, transform);
    std::vector<float> values(picture.pixels() * 3);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < picture.pixels(); ++i)
            values[i * 3 + c] = srgb_encode(planes.at(c)[i]);
    return values;
}

}  // namespace sunfleck::engine
