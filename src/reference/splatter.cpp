// Filters around points of the film.
#include "reference/splatter.h"

#include <cmath>

namespace sunfleck {

Splatter::Splatter(const ReferencePass& pass, PassImage& image)
    : filter_(pass.scene.scene.filter()),
      scale_(pass.scene.scene.film().imaging_ratio / filter_integral(filter_)),
      window_(pass.window),
      reach_{window_.x0 - filter_.radius.x, window_.x1 + filter_.radius.x,
             window_.y0 - filter_.radius.y, window_.y1 + filter_.radius.y},
      wavelengths_(pass.scene.wavelengths),
      image_(image) {}

void Splatter::add(const Vec2d& film, const Spectrum& light) const {
    const auto [x0, y0, x1, y1] = window_;
    const auto first = [](double at, double radius, int least) {
        return std::max(least, static_cast<int>(std::ceil(at - radius - 0.5)));
    };
    const auto last = [](double at, double radius, int most) {
        return std::min(most - 1, static_cast<int>(std::floor(at + radius - 0.5)));
    };
    const Vec3 rgb = wavelengths_.to_rgb(light);
    for (int y = first(film.y, filter_.radius.y, y0); y <= last(film.y, filter_.radius.y, y1); ++y)
        for (int x = first(film.x, filter_.radius.x, x0); x <= last(film.x, filter_.radius.x, x1);
             ++x) {
            const double weight = filter_value(filter_, film - Vec2d(x + 0.5, y + 0.5)) * scale_;
            image_.add_light(static_cast<std::size_t>((y - y0) * (x1 - x0) + x - x0),
                             rgb * static_cast<float>(weight), Layer::total);
        }
}

}  // namespace sunfleck
