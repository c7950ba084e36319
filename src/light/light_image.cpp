// Sums over texels, and their inversion.
#include "light/light_image.h"

#include "core/parallel.h"
#include "math/colour.h"
#include "math/sigmoid_table.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// A position on [0,1]: the cell, the offset from its left end, and the density.
struct Place {
    std::size_t cell;
    double along;
    double density;
};

/// @param ends  cumulative sums of the cells; the last one is one.
Place invert(const double* ends, std::size_t count, double u) {
    const double* end = std::upper_bound(ends, ends + count, std::min(u, 1 - 0x1p-53));
    const auto cell = static_cast<std::size_t>(end - ends);
    const double begin = cell == 0 ? 0 : ends[cell - 1];
    const double share = *end - begin;
    const auto cells = static_cast<double>(count);
    return {cell, (static_cast<double>(cell) + (u - begin) / share) / cells, share * cells};
}

/// Divides sums by the last one.
void normalise(double* sums, std::size_t count) {
    const double total = sums[count - 1];
    if (!(total > 0)) return;
    for (std::size_t i = 0; i < count; ++i) sums[i] /= total;
}

}  // namespace

TexelLight texel_light(const Vec3& given) {
    const Vec3d rgb(std::max(0.0F, given.x), std::max(0.0F, given.y), std::max(0.0F, given.z));
    const double luminance =
        rgb.dot({kLuminanceWeights[0], kLuminanceWeights[1], kLuminanceWeights[2]});
    if (!(luminance > 0)) return {};
    if (rgb.x == rgb.y && rgb.y == rgb.z) return {rgb.x, Vec3(1)};
    return {luminance, Vec3(rgb / luminance)};
}

void prepare_colours(const Image& image) {
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x)
            if (texel_light(image.rgb(x, y)).rgb != Vec3(1)) {
                SigmoidTable::srgb();
                return;
            }
}

LightImage::LightImage(Image image, const Share& share) : image_(std::move(image)) {
    const Vec2i size = image_.resolution();
    const auto width = static_cast<std::size_t>(size.x);
    const auto height = static_cast<std::size_t>(size.y);
    rows_.resize(height);
    columns_.resize(width * height);
    std::vector<double> peaks(height);
    parallel_for(height, [&](std::size_t y) { peaks[y] = sum_row(static_cast<int>(y), share); });
    peak_ = *std::max_element(peaks.begin(), peaks.end());
    for (std::size_t y = 1; y < height; ++y) rows_[y] += rows_[y - 1];
    mean_ = rows_.back() / static_cast<double>(width * height);
    normalise(rows_.data(), height);
    prepare_colours(image_);
}

double LightImage::sum_row(int y, const Share& share) {
    const auto width = static_cast<std::size_t>(image_.resolution().x);
    double* row = &columns_[static_cast<std::size_t>(y) * width];
    double sum = 0;
    double peak = 0;
    for (std::size_t x = 0; x < width; ++x) {
        const auto column = static_cast<int>(x);
        const double luminance = texel(column, y).luminance;
        sum += luminance * (share ? share(column, y) : 1);
        peak = std::max(peak, luminance);
        row[x] = sum;
    }
    rows_[static_cast<std::size_t>(y)] = sum;
    normalise(row, width);
    return peak;
}

Vec2i LightImage::cell(const Vec2d& place) const {
    const auto along = [](double x, int count) {
        return std::clamp(static_cast<int>(x * count), 0, count - 1);
    };
    const Vec2i size = image_.resolution();
    return {along(place.x, size.x), along(place.y, size.y)};
}

TexelLight LightImage::at(const Vec2d& place) const {
    const Vec2i at = cell(place);
    return texel(at.x, at.y);
}

Vec2d LightImage::numbers(const Vec2d& place) const {
    const Vec2i size = image_.resolution();
    const Vec2i at = cell(place);
    const auto number = [](const double* ends, int i, double along) {
        const double begin = i > 0 ? ends[i - 1] : 0;
        return begin + (ends[i] - begin) * std::clamp(along - i, 0.0, 1.0);
    };
    const double* row =
        &columns_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x)];
    return {number(row, at.x, place.x * size.x), number(rows_.data(), at.y, place.y * size.y)};
}

double LightImage::density(const Vec2d& place) const {
    const Vec2i size = image_.resolution();
    const Vec2i at = cell(place);
    const auto share = [](const double* ends, int i) {
        return ends[i] - (i > 0 ? ends[i - 1] : 0);
    };
    const double* row =
        &columns_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x)];
    return share(rows_.data(), at.y) * size.y * share(row, at.x) * size.x;
}

LightImage::Drawn LightImage::draw(const Vec2d& u) const {
    const auto width = static_cast<std::size_t>(image_.resolution().x);
    const Place row = invert(rows_.data(), rows_.size(), u.y);
    const Place column = invert(&columns_[row.cell * width], width, u.x);
    return {{column.along, row.along},
            texel(static_cast<int>(column.cell), static_cast<int>(row.cell)),
            row.density * column.density};
}

}  // namespace sunfleck::engine
