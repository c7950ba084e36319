// Sampling of environments over the texels of a square map.
#include "export/light_images.h"

#include "core/parallel.h"
#include "light/direction_map.h"
#include "math/warp.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr int kLooksPerSide = 8;  // of a texel
constexpr int kLeastPortalTexels = 256;
constexpr int kMostSunTexels = 2048;
constexpr double kTexelsAcrossSun = 5;

/// Returns a square map of n x n texels, each the mean of `light` over its part of the sphere.
/// @param light  linear RGB from a direction.
/// @param margin  texels at each edge that are black.
std::vector<Vec3d> means_over_texels(int n, const std::function<Vec3d(const Vec3d&)>& light,
                                     int margin = 0) {
    const auto side = static_cast<std::size_t>(n);
    const auto first = static_cast<std::size_t>(margin);
    std::vector<Vec3d> texels(side * side, Vec3d(0));
    const auto mean = [&](std::size_t x, std::size_t y) {
        Vec3d sum(0);
        for (int j = 0; j < kLooksPerSide; ++j)
            for (int i = 0; i < kLooksPerSide; ++i) {
                const Vec2d place(static_cast<double>(x) + (i + 0.5) / kLooksPerSide,
                                  static_cast<double>(y) + (j + 0.5) / kLooksPerSide);
                sum += light(uniform_sphere(place / n));
            }
        return sum / (kLooksPerSide * kLooksPerSide);
    };
    parallel_for(side - 2 * first, [&](std::size_t row) {
        const std::size_t y = first + row;
        for (std::size_t x = first; x < side - first; ++x) texels[y * side + x] = mean(x, y);
    });
    return texels;
}

std::shared_ptr<const Image> image_of_texels(int n, const std::vector<Vec3d>& texels,
                                             const Vec3d& by) {
    std::vector<float> values;
    values.reserve(3 * texels.size());
    for (const Vec3d& texel : texels)
        for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(texel[c] * by[c]));
    return std::make_shared<const Image>(Vec2i(n, n), 3, std::move(values));
}

Vec3d colour_of_texel(const TexelLight& texel) {
    return Vec3d(texel.rgb) * texel.luminance;
}

std::shared_ptr<const Image> as_it_is(const LightImage& image) {
    const int n = image.resolution().x;
    std::vector<Vec3d> texels;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) texels.push_back(colour_of_texel(image.texel(x, y)));
    return image_of_texels(n, texels, Vec3d(1));
}

/// Returns the mean over the sphere.
Vec3d mean_light(const LightImage& image, const DirectionMap& map) {
    const Vec2i size = image.resolution();
    Vec3d sum(0);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) sum += colour_of_texel(image.texel(x, y)) * map.share(y);
    return sum / (static_cast<double>(size.x) * size.y);
}

}  // namespace

std::shared_ptr<const Image> equal_area_image(const ImageInfiniteLight& light) {
    const LightImage& image = *light.image;
    if (light.map.has_equal_areas()) return as_it_is(image);
    const int n = 2 * image.resolution().y;
    const std::vector<Vec3d> texels = means_over_texels(
        n, [&](const Vec3d& w) { return colour_of_texel(image.at(light.map.place(w))); });
    Vec3d sum(0);
    for (const Vec3d& texel : texels) sum += texel;
    const Vec3d wanted = mean_light(image, light.map) * static_cast<double>(texels.size());
    Vec3d by(1);
    for (int c = 0; c < 3; ++c)
        if (sum[c] > 0) by[c] *= wanted[c] / sum[c];
    return image_of_texels(n, texels, by);
}

std::shared_ptr<const Image> portal_view(const PortalLight& light) {
    const LightImage& through = light.image->through();
    const int n = std::max(2 * through.resolution().x, kLeastPortalTexels);
    const auto seen = [&](const Vec3d& w) {
        const Vec3d front(w.x, w.y, std::max(std::abs(w.z), 1e-6));
        return colour_of_texel(through.at(portal_place(front)));
    };
    return image_of_texels(n, means_over_texels(n, seen), Vec3d(1));
}

std::optional<SunImage> sun_image(const SunLight& light) {
    // A texel has 4 pi / n^2, a disc across which k of them lie about (pi / 4) k^2 of them.
    const double disc = 2 * kPiDouble * light.versine;
    const double needed = kTexelsAcrossSun * kPiDouble / std::sqrt(disc);
    if (!(needed <= kMostSunTexels)) return {};
    const int n = std::clamp(2 * static_cast<int>(needed), 256, kMostSunTexels);
    SunImage sun;
    const Vec3d to_sun = -light.direction;
    sun.to_world.x = rotate_z_to(to_sun, {1, 0, 0});
    sun.to_world.y = rotate_z_to(to_sun, {0, 1, 0});
    sun.to_world.z = to_sun;
    const auto radiance = [&](const Vec3d& w) {
        if (w.z < 1 - 2 * light.versine) return Vec3d(0);
        const Vec3 direction(sun.to_world.vector(w));
        return Vec3d(static_cast<double>(light.environment_radiance(Vec3(0), direction).factor));
    };
    // The disc is the square |a| + |b| <= sqrt(versine) of the map, whose sides go from -1 to 1.
    const double half = std::min(1.0, std::sqrt(light.versine)) * n / 2;
    const int margin = std::max(0, n / 2 - static_cast<int>(half) - 2);
    const std::vector<Vec3d> texels = means_over_texels(n, radiance, margin);
    double sum = 0;
    double most = 0;
    for (const Vec3d& texel : texels) {
        sum += texel.x;
        most = std::max(most, texel.x);
    }
    if (!(sum > 0)) return {};
    // The disc's radiance adds up to one.
    const double whole = static_cast<double>(texels.size()) / (4 * kPiDouble * sum);
    sun.peak = static_cast<float>(most * whole);
    sun.image = image_of_texels(n, texels, Vec3d(1 / most));
    return sun;
}

}  // namespace sunfleck::engine
