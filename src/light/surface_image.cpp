// Image lookups, and tables of the emission of textured area lights.
#include "light/surface_image.h"

#include "image/lookup.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Lower bound of a cell's density, relative to the mean.
constexpr double kEverywhere = 0.02;

}  // namespace

SurfaceImage::SurfaceImage(Image image) : image_(std::move(image)) {
    const Vec2i size = image_.resolution();
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double luminance = texel_light(image_.rgb(x, y)).luminance;
            mean_ += luminance;
            peak_ = std::max(peak_, luminance);
        }
    mean_ /= static_cast<double>(size.x) * size.y;
    prepare_colours(image_);
}

TexelLight SurfaceImage::at(const Vec2& uv) const {
    const auto v = bilinear(image_, {uv.x, 1 - uv.y}, Wrap::clamp);
    return texel_light(image_.channels() < 3 ? Vec3(v[0]) : Vec3(v[0], v[1], v[2]));
}

// NOLINTNEXTLINE(modernize-pass-by-value): moving it costs as much, and GCC 12 warns of it
PlacedImage::PlacedImage(std::shared_ptr<const SurfaceImage> image, const CornerUvs& uvs,
                         const EmittingSurface& surface, int most_cells)
    : image_(std::move(image)), uvs_(uvs) {
    if (!has_corners(surface)) uvs_ = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)};
    if (std::holds_alternative<EmittingTriangle>(surface)) uvs_[3] = uvs_[2];
    const int side = cells_across(most_cells);
    std::vector<float> cells;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double luminance = mean_over(surface, {x, y}, side);
            flux_ += luminance / (double{1} * side * side);
            cells.push_back(static_cast<float>(luminance));
        }
    const auto floor = static_cast<float>(kEverywhere * flux_);
    for (float& cell : cells) cell += floor;
    slots_ = std::make_unique<const LightImage>(Image({side, side}, 1, std::move(cells)));
}

/// Returns luminance by area of one of side x side cells, from four samples.
double PlacedImage::mean_over(const EmittingSurface& surface, const Vec2i& cell, int side) const {
    double sum = 0;
    for (const double right : {0.25, 0.75})
        for (const double below : {0.25, 0.75}) {
            const Vec2d u((cell.x + right) / side, (cell.y + below) / side);
            const SurfaceSample on = sample_surface(surface, u);
            sum += on.spread * at(surface, on.position, on.normal).luminance / 4;
        }
    return sum;
}

/// Returns eight cells per texel, limited by `most_cells`.
int PlacedImage::cells_across(int most_cells) const {
    Vec2 low = uvs_[0];
    Vec2 high = uvs_[0];
    for (const Vec2& uv : uvs_) {
        low = {std::min(low.x, uv.x), std::min(low.y, uv.y)};
        high = {std::max(high.x, uv.x), std::max(high.y, uv.y)};
    }
    const Vec2 texels = (high - low) * Vec2(image_->resolution());
    const float wanted = std::clamp(8 * std::max(texels.x, texels.y), 4.0F, 256.0F);
    const auto room = std::sqrt(static_cast<float>(most_cells));
    return std::max(static_cast<int>(std::min(wanted, room)), 1);
}

PlacedImage::Drawn PlacedImage::draw(const EmittingSurface& surface, const Vec2d& u) const {
    const LightImage::Drawn slot = slots_->draw(u);
    const SurfaceSample on = sample_surface(surface, slot.place);
    return {on, at(surface, on.position, on.normal), slot.density};
}

Vec2d PlacedImage::numbers(const EmittingSurface& surface, const Vec3d& on,
                           const Vec3d& normal) const {
    return slots_->numbers(surface_square(surface, on, normal));
}

double PlacedImage::density(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal,
                            double spread) const {
    const double luminance = at(surface, on, normal).luminance;
    return (luminance / flux_ + kEverywhere / spread) / (1 + kEverywhere);
}

TexelLight PlacedImage::at(const EmittingSurface& surface, const Vec3d& on,
                           const Vec3d& normal) const {
    return at(uv_at(surface, uvs_, on, normal));
}

}  // namespace sunfleck::engine
