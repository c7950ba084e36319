// Examples of every kind of density; the laws of densities hold for all of them.
#pragma once

#include "core/random.h"
#include "geometry/support.h"
#include "medium/density.h"
#include "medium/density_samples.h"

#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::engine::test {

struct DensityExample {
    std::string name;
    Density density;
    Matrix box_to_world;  // of the unit cube; the density is zero outside of its image

    friend std::ostream& operator<<(std::ostream& out, const DensityExample& e) {
        return out << e.name;
    }
};

/// Returns random values, of which most are zero if `holes` is near one, in clusters.
inline std::vector<float> random_values(const Voxel& count, float holes) {
    RandomStream random(11, Purpose::test, 0, 0);
    std::vector<float> values;
    for (int z = 0; z < count[2]; ++z)
        for (int y = 0; y < count[1]; ++y)
            for (int x = 0; x < count[0]; ++x) {
                const int cluster = x / 9 + 7 * (y / 11) + 13 * (z / 10);
                const bool empty = static_cast<float>(cluster * 37 % 101) < holes * 101;
                const float value = random.next_float();
                values.push_back(empty ? 0 : 2 * value);
            }
    return values;
}

/// At least one of each alternative of Density (a test counts them).
inline std::vector<DensityExample> density_examples() {
    const Matrix unit;
    const Matrix turned = scaling(2, 1, 3) * rotation({1, 2, 3}, 0.9) * translation({0.5, -4, 2});
    const Matrix mirrored = scaling(-1.5, 0.7, 0.4) * turned;
    const Matrix far = scaling(40, 50, 60) * translation({3e4, -2e4, 1e4});
    const auto parts = [](const std::string& name, const Voxel& count, float holes,
                          const Matrix& to_world) {
        const auto values = random_values(count, holes);
        return DensityExample{name, density_of_parts(values, count, Affine(to_world)), to_world};
    };
    const auto points = random_values({21, 12, 9}, 0);
    return {parts("one_value", {1, 1, 1}, 0, unit),
            parts("few_values", {2, 3, 4}, 0, mirrored),
            parts("many_values", {40, 23, 31}, 0, turned),
            parts("mostly_empty", {61, 70, 50}, 0.9F, turned),
            parts("nothing", {9, 9, 9}, 1.1F, turned),
            parts("far_away", {33, 20, 17}, 0.5F, far),
            {"points", density_of_points(points, {20, 11, 8}, Affine(turned)), turned}};
}

}  // namespace sunfleck::engine::test
