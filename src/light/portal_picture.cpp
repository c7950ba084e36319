// Rectified skies, and inverting sums of their cells within a window.
#include "light/portal_picture.h"

#include "core/parallel.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr int kLooks = 4;  // each way, in a cell

double half_of(double t) {
    return (1 + t / (1 + std::abs(t))) / 2;
}

/// Calls use(uv) at the midpoints of the parts of a cell.
template <class Use>
void looks(int x, int y, int side, const Use& use) {
    for (int j = 0; j < kLooks; ++j)
        for (int i = 0; i < kLooks; ++i)
            use(Vec2d((x + (i + 0.5) / kLooks) / side, (y + (j + 0.5) / kLooks) / side));
}

/// The mean over a cell.
template <class Value>
double cell_mean(int x, int y, int side, const Value& value) {
    double sum = 0;
    looks(x, y, side, [&](const Vec2d& uv) { sum += value(uv); });
    return sum / (kLooks * kLooks);
}

/// The sky's mean over the directions of a cell.
Vec3 mean_of_sky(int x, int y, int side, const PortalPicture::Sky& sky) {
    double solid_angle = 0;
    Vec3d sum(0);
    looks(x, y, side, [&](const Vec2d& uv) {
        const PortalDirection there = portal_direction(uv);
        solid_angle += there.solid_angle;
        sum += Vec3d(sky(there.w)) * there.solid_angle;
    });
    const Vec3 mean(sum / solid_angle);
    return mean;
}

Image rectified(int side, const PortalPicture::Sky& sky) {
    const auto n = static_cast<std::size_t>(side);
    std::vector<float> texels(3 * n * n);
    parallel_for(n, [&](std::size_t row) {
        for (std::size_t x = 0; x < n; ++x) {
            const Vec3 rgb = mean_of_sky(static_cast<int>(x), static_cast<int>(row), side, sky);
            for (int c = 0; c < 3; ++c)
                texels[3 * (row * n + x) + static_cast<std::size_t>(c)] = rgb[c];
        }
    });
    return {{side, side}, 3, std::move(texels)};
}

double projected_share(int x, int y, int side) {
    return cell_mean(x, y, side, [](const Vec2d& uv) {
        const PortalDirection there = portal_direction(uv);
        return there.solid_angle * there.w.z;
    });
}

/// The cell of a number within [0, side], the greatest `i` with i <= x, and below side.
int cell_of(double x, int side) {
    return std::clamp(static_cast<int>(x), 0, side - 1);
}

}  // namespace

PortalDirection portal_direction(const Vec2d& uv) {
    const double a = 2 * uv.x - 1;
    const double b = 2 * uv.y - 1;
    // t = a / (1 - |a|), dt = 2 du (1 + |t|)^2; d(solid angle) = z^3 dt ds.
    const double stretch_a = 1 / std::max(1 - std::abs(a), 1e-9);
    const double stretch_b = 1 / std::max(1 - std::abs(b), 1e-9);
    const Vec3d w = Vec3d(a * stretch_a, b * stretch_b, 1).normalized();
    return {w, 4 * stretch_a * stretch_a * stretch_b * stretch_b * w.z * w.z * w.z};
}

Vec2d portal_place(const Vec3d& w) {
    return {half_of(w.x / w.z), half_of(w.y / w.z)};
}

PortalPicture::PortalPicture(int side, const Sky& sky)
    : through_(rectified(side, sky), [side](int x, int y) { return projected_share(x, y, side); }),
      side_(side),
      sums_(static_cast<std::size_t>(side + 1) * static_cast<std::size_t>(side + 1)) {
    const auto n = static_cast<std::size_t>(side);
    for (std::size_t y = 0; y < n; ++y) {
        double row = 0;
        for (std::size_t x = 0; x < n; ++x) {
            row += weight(static_cast<int>(x), static_cast<int>(y));
            sums_[(y + 1) * (n + 1) + x + 1] = sums_[y * (n + 1) + x + 1] + row;
        }
    }
}

double PortalPicture::weight(int column, int row) const {
    const auto solid_angle = [](const Vec2d& uv) { return portal_direction(uv).solid_angle; };
    return through_.texel(column, row).luminance * cell_mean(column, row, side_, solid_angle);
}

/// Of all left of and above a place, in cells: bilinear within one.
double PortalPicture::mass(double x, double y) const {
    const int column = cell_of(x, side_);
    const int row = cell_of(y, side_);
    const auto stride = static_cast<std::size_t>(side_ + 1);
    const double* at =
        &sums_[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)];
    const double right = x - column;
    const double below = y - row;
    return (at[0] * (1 - right) + at[1] * right) * (1 - below) +
           (at[stride] * (1 - right) + at[stride + 1] * right) * below;
}

double PortalPicture::mass(const PortalWindow& window) const {
    const Vec2d low = window.low * side_;
    const Vec2d high = window.high * side_;
    return mass(high.x, high.y) - mass(low.x, high.y) - (mass(high.x, low.y) - mass(low.x, low.y));
}

namespace {

/// Where a function that rises, linear between whole numbers, reaches `wanted`, in [low, high].
template <class Rising>
double reached(const Rising& rising, double low, double high, double wanted) {
    // Whole numbers strictly between the ends: the first at which it is reached.
    int from = static_cast<int>(std::floor(low)) + 1;
    int to = static_cast<int>(std::ceil(high));
    while (from < to) {
        const int middle = (from + to) / 2;
        if (rising(middle) >= wanted)
            to = middle;
        else
            from = middle + 1;
    }
    const double begin = std::max(low, double{1} * from - 1);
    const double end = std::min(high, double{1} * from);
    const double at_begin = rising(begin);
    const double gain = rising(end) - at_begin;
    if (!(gain > 0)) return end;
    return std::clamp(begin + (end - begin) * (wanted - at_begin) / gain, begin, end);
}

}  // namespace

std::optional<PortalPicture::Drawn> PortalPicture::draw(const PortalWindow& window,
                                                        const Vec2d& u) const {
    const double total = mass(window);
    if (!(total > 0)) return {};
    const Vec2d low = window.low * side_;
    const Vec2d high = window.high * side_;
    const auto above = [&](double y) {
        return mass(high.x, y) - mass(low.x, y) - (mass(high.x, low.y) - mass(low.x, low.y));
    };
    const double y = reached(above, low.y, high.y, u.y * total);
    const double top = cell_of(y, side_);
    const auto left = [&](double x) { return mass(x, top + 1) - mass(x, top); };
    const double left_of_all = left(low.x);
    const double width = left(high.x) - left_of_all;
    const double x = reached(left, low.x, high.x, left_of_all + u.x * width);
    const TexelLight light = through_.texel(cell_of(x, side_), cell_of(y, side_));
    const Vec2d uv = Vec2d(x, y) / side_;
    return Drawn{uv, light, density(window, uv)};
}

double PortalPicture::density(const PortalWindow& window, const Vec2d& uv) const {
    const double total = mass(window);
    if (!(total > 0) || !window.contains(uv)) return 0;
    const Vec2d at = uv * side_;
    const double here = weight(cell_of(at.x, side_), cell_of(at.y, side_));
    return here * side_ * side_ / total;
}

}  // namespace sunfleck::engine
