// What the command line changes in a scene before it is built.
#include "scene/adjust.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// The same share of another extent, of one pixel at least. @param low, high  of `before` pixels.
void keep_share(int& low, int& high, int before, int now) {
    const auto moved = [&](int pixel) {
        return static_cast<int>(std::int64_t{pixel} * now / before);
    };
    low = moved(low);
    high = std::max(moved(high), low + 1);
}

}  // namespace

void set_resolution(SceneDescription& scene, const Vec2i& resolution) {
    const Vec2i before = scene.film.resolution;
    set_resolution(scene.camera, resolution);
    scene.film.resolution = resolution;
    if (scene.film.crop) {
        auto& crop = *scene.film.crop;
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

void set_crop(SceneDescription& scene, const std::array<int, 4>& crop, const std::string& flag) {
    const Vec2i size = scene.film.resolution;
    const auto is_run = [](int begin, int end, int most) {
        return 0 <= begin && begin < end && end <= most;
    };
    if (!is_run(crop[0], crop[1], size.x) || !is_run(crop[2], crop[3], size.y))
        throw Error({flag}, "is no part of the picture",
                    "give x0,x1,y0,y1 in pixels, with 0 <= x0 < x1 <= " + std::to_string(size.x) +
                        " and 0 <= y0 < y1 <= " + std::to_string(size.y));
    scene.film.crop = crop;
}

void compensate_energy(SceneDescription& scene) {
    for (Material& material : scene.materials) {
        if (auto* metal = std::get_if<ConductorMaterial>(&material))
            metal->roughness.gives_back = true;
        if (auto* glass = std::get_if<DielectricMaterial>(&material))
            glass->roughness.gives_back = true;
    }
}

}  // namespace sunfleck::engine
