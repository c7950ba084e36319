// Filters around points of the film.
#include "reference/splatter.h"

#include "camera/film_images.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// A spherical film goes on beyond its edges: a point of it may reach any pixel.
std::array<double, 4> reach_of(const ReferencePass& pass) {
    if (const auto* sphere = std::get_if<SphericalCamera>(&pass.scene.scene.camera()))
        return {0, double(sphere->resolution.x), 0, double(sphere->resolution.y)};
    const PixelWindow& window = pass.window;
    const Vec2d& radius = pass.scene.scene.filter().radius;
    return {window.x0 - radius.x, window.x1 + radius.x, window.y0 - radius.y, window.y1 + radius.y};
}

}  // namespace

Splatter::Splatter(const ReferencePass& pass, PassImage& image)
    : filter_(pass.scene.scene.filter()),
      scale_(pass.scene.scene.film().imaging_ratio / filter_integral(filter_)),
      window_(pass.window),
      reach_(reach_of(pass)),
      camera_(pass.scene.scene.camera()),
      wavelengths_(pass.scene.wavelengths),
      image_(image) {}

void Splatter::add(const Vec2d& film, const SampledSpectrum& light) const {
    const Vec3 rgb = wavelengths_.to_rgb(light);
    for (const Vec2d& image : film_images(camera_, film)) add_at(image, rgb);
}

void Splatter::add_at(const Vec2d& film, const Vec3& rgb) const {
    const auto [x0, y0, x1, y1] = window_;
    const auto first = [](double at, double radius, int least) {
        return std::max(least, static_cast<int>(std::ceil(at - radius - 0.5)));
    };
    const auto last = [](double at, double radius, int most) {
        return std::min(most - 1, static_cast<int>(std::floor(at + radius - 0.5)));
    };
    for (int y = first(film.y, filter_.radius.y, y0); y <= last(film.y, filter_.radius.y, y1); ++y)
        for (int x = first(film.x, filter_.radius.x, x0); x <= last(film.x, filter_.radius.x, x1);
             ++x) {
            const double weight = filter_value(filter_, film - Vec2d(x + 0.5, y + 0.5)) * scale_;
            image_.add_light(static_cast<std::size_t>((y - y0) * (x1 - x0) + x - x0),
                             rgb * static_cast<float>(weight), Aov::total);
        }
}

}  // namespace sunfleck::engine
