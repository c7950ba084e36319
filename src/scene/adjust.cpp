// Film sizes and crops, and energy compensation.
#include "scene/adjust.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Scales an interval to another extent, at least one pixel long. @param low, high  of `before`
/// pixels.
void keep_share(int& low, int& high, int before, int now) {
    const auto moved = [&](int pixel) {
        return static_cast<int>(std::int64_t{pixel} * now / before);
    };
    low = moved(low);
    high = std::max(moved(high), low + 1);
}

}  // namespace

bool is_film_size(const Vec2i& size) {
    constexpr int kLongestSide = 65536;
    constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
    const auto is_side = [](int pixels) { return pixels > 0 && pixels <= kLongestSide; };
    return is_side(size.x) && is_side(size.y) && std::int64_t{size.x} * size.y <= kMostPixels;
}

void check_film_size(const Vec2i& size, const SourceLocation& where) {
    if (is_film_size(size)) return;
    throw Error(
        where,
        "a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels",
        "use 1 to 65536 a side, and at most 268435456 pixels");
}

void set_resolution(Camera& camera, FilmDescription& film, const Vec2i& resolution) {
    const Vec2i before = film.resolution;
    set_resolution(camera, resolution);
    film.resolution = resolution;
    if (film.crop) {
        auto& crop = *film.crop;
        keep_share(crop[0], crop[1], before.x, resolution.x);
        keep_share(crop[2], crop[3], before.y, resolution.y);
    }
}

std::array<int, 4> pixels_of_window(const std::array<double, 4>& window, const Vec2i& size) {
    const auto pixel = [](double fraction, int extent) {
        const float clamped = std::clamp(static_cast<float>(fraction), 0.0F, 1.0F);
        return static_cast<int>(std::ceil(static_cast<float>(extent) * clamped));
    };
    return {pixel(std::min(window[0], window[1]), size.x),
            pixel(std::max(window[0], window[1]), size.x),
            pixel(std::min(window[2], window[3]), size.y),
            pixel(std::max(window[2], window[3]), size.y)};
}

void set_crop(FilmDescription& film, const std::array<int, 4>& crop, const std::string& flag) {
    const Vec2i size = film.resolution;
    const auto is_run = [](int begin, int end, int most) {
        return 0 <= begin && begin < end && end <= most;
    };
    if (!is_run(crop[0], crop[1], size.x) || !is_run(crop[2], crop[3], size.y))
        throw Error({flag}, "is not within the picture",
                    "give x0,x1,y0,y1 in pixels, with 0 <= x0 < x1 <= " + std::to_string(size.x) +
                        " and 0 <= y0 < y1 <= " + std::to_string(size.y));
    film.crop = crop;
}

void compensate_energy(std::vector<Material>& materials) {
    for (Material& material : materials) {
        if (auto* metal = std::get_if<ConductorMaterial>(&material))
            metal->roughness.gives_back = true;
        if (auto* glass = std::get_if<DielectricMaterial>(&material))
            glass->roughness.gives_back = true;
    }
}

}  // namespace sunfleck::engine
