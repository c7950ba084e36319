// Noise, sampled once.
#include "import/pbrt/cloud.h"

#include "core/parallel.h"
#include "medium/density_samples.h"
#include "texture/noise.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kOctaves = 5;
constexpr float kPerOctave = 1.99F;
constexpr int kMostParts = 160;  // along an axis
constexpr int kFewestParts = 8;

/// Returns the slope of noise along each axis, by pbrt-v4's differences.
Vec3 slope_of_noise(const Vec3& p) {
    constexpr float kStep = 0.01F;
    const float here = noise(p);
    return Vec3(noise(p + Vec3(kStep, 0, 0)) - here, noise(p + Vec3(0, kStep, 0)) - here,
                noise(p + Vec3(0, 0, kStep)) - here) /
           kStep;
}

int parts_for(double length, const CloudShape& shape) {
    const double finest = std::pow(static_cast<double>(kPerOctave), kOctaves - 1) *
                          static_cast<double>(shape.frequency);
    return static_cast<int>(
        std::clamp(std::ceil(2 * finest * length), double{kFewestParts}, double{kMostParts}));
}

}  // namespace

float cloud_at(const CloudShape& shape, const Vec3& point) {
    Vec3 at = point * shape.frequency;
    float shift = 0.05F * shape.wispiness;
    float frequency = 10;
    for (int i = 0; i < 2 && shape.wispiness > 0; ++i) {
        at += slope_of_noise(at * frequency) * shift;
        shift *= 0.5F;
        frequency *= kPerOctave;
    }
    const float sum = 0.5F * fbm(at, {kOctaves, 0.5F});
    const float wisps = std::clamp((1 - point.y) * 4.5F * shape.density * sum, 0.0F, 1.0F);
    return std::clamp(wisps + 2 * std::max(0.0F, 0.5F - point.y), 0.0F, 1.0F);
}

DensityGrid cloud_density(const CloudShape& shape, const Affine& box, const Affine& to_world) {
    const Voxel parts = {parts_for(box.x.length(), shape), parts_for(box.y.length(), shape),
                         parts_for(box.z.length(), shape)};
    const auto row = static_cast<std::size_t>(parts[0]) + 1;
    const auto rows = static_cast<std::size_t>(parts[1]) + 1;
    const auto layers = static_cast<std::size_t>(parts[2]) + 1;
    std::vector<float> values(row * rows * layers);
    parallel_for(layers, [&](std::size_t z) {
        float* value = values.data() + z * rows * row;
        for (int y = 0; y <= parts[1]; ++y)
            for (int x = 0; x <= parts[0]; ++x) {
                const Vec3d unit(static_cast<double>(x) / parts[0],
                                 static_cast<double>(y) / parts[1],
                                 static_cast<double>(z) / parts[2]);
                *value++ = cloud_at(shape, Vec3(box.point(unit)));
            }
    });
    Affine placed;
    placed.x = to_world.vector(box.x);
    placed.y = to_world.vector(box.y);
    placed.z = to_world.vector(box.z);
    placed.origin = to_world.point(box.origin);
    return density_of_points(values, parts, placed);
}

}  // namespace sunfleck::engine
