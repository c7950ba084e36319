// Heights of rows, and azimuths.
#include "light/direction_map.h"

#include "math/warp.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns the azimuth as a fraction of a turn, in [0, 1].
double turn_of(double x, double y) {
    const double wide = std::abs(x);
    const double high = std::abs(y);
    const double longer = std::max(wide, high);
    if (!(longer > 0)) return 0;
    // In double the last bits of atan differ between machines; in float they do not.
    const float slope = static_cast<float>(std::min(wide, high) / longer);
    const double eighth = static_cast<double>(std::atan(slope)) / (2 * kPiDouble);
    const double quarter = wide >= high ? eighth : 0.25 - eighth;
    const double half = x >= 0 ? quarter : 0.5 - quarter;
    return y >= 0 ? half : 1 - half;
}

}  // namespace

DirectionMap DirectionMap::latitude_longitude(int rows) {
    std::vector<double> heights;
    for (int row = 0; row <= rows; ++row) heights.push_back(sin_cos_2pi(row / (2.0 * rows)).cos);
    DirectionMap map;
    map.heights_ = std::make_shared<const std::vector<double>>(std::move(heights));
    return map;
}

Vec3d DirectionMap::direction(const Vec2d& place) const {
    if (!heights_) return uniform_sphere(place);
    const std::vector<double>& ends = *heights_;
    const auto rows = static_cast<int>(ends.size()) - 1;
    const int row = std::clamp(static_cast<int>(place.y * rows), 0, rows - 1);
    const auto i = static_cast<std::size_t>(row);
    const double z =
        std::clamp(ends[i] + (ends[i + 1] - ends[i]) * (place.y * rows - row), -1.0, 1.0);
    const SinCos azimuth = sin_cos_2pi(place.x);
    const double flat = std::sqrt((1 - z) * (1 + z));
    return {flat * azimuth.cos, flat * azimuth.sin, z};
}

Vec2d DirectionMap::place(const Vec3d& w) const {
    if (!heights_) return sphere_to_square(w);
    const std::vector<double>& ends = *heights_;
    const auto below = std::upper_bound(ends.begin() + 1, ends.end() - 1, w.z, std::greater<>());
    const double row = static_cast<double>(below - ends.begin() - 1);
    const double begin = *(below - 1);
    const double along = std::clamp((begin - w.z) / (begin - *below), 0.0, 1.0);
    return {turn_of(w.x, w.y), (row + along) / static_cast<double>(ends.size() - 1)};
}

double DirectionMap::share(int row) const {
    if (!heights_) return 1;
    const auto i = static_cast<std::size_t>(row);
    return ((*heights_)[i] - (*heights_)[i + 1]) * static_cast<double>(heights_->size() - 1) / 2;
}

std::optional<DirectionMap> map_of_size(const Vec2i& size) {
    if (size.x == size.y) return DirectionMap();
    if (size.x == 2 * size.y) return DirectionMap::latitude_longitude(size.y);
    return {};
}

}  // namespace sunfleck::engine
