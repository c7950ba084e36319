// Clouds: their sampled density against the noise itself.
#include "import/pbrt/cloud.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

Affine box_of(double low, double size) {
    Affine box;
    box.x.x = box.y.y = box.z.z = size;
    box.origin = Vec3d(low);
    return box;
}

TEST(Cloud, is_full_at_the_ground_and_empty_above_one) {
    const CloudShape shape;
    EXPECT_EQ(cloud_at(shape, Vec3(0.3F, 0, 0.4F)), 1);
    EXPECT_EQ(cloud_at(shape, Vec3(0.3F, 1.2F, 0.4F)), 0);
}

/// A lattice leaves out what is finer: along ways through a box of one 1% of the mean, of two 2.4%,
/// with no more or less cloud. Would see a sample in another place, or an octave that is missing.
TEST(Cloud, samples_are_the_noise_along_ways) {
    for (const bool is_large : {false, true}) {
        const CloudShape shape{.density = 3, .wispiness = 1, .frequency = 5};
        const DensityGrid grid =
            cloud_density(shape, is_large ? box_of(-1, 2) : box_of(0, 1), Affine());
        RandomStream random(5, Purpose::test, 0, 0);
        double all = 0;
        double excess = 0;
        double square = 0;
        constexpr int kWays = 60;
        constexpr int kSteps = 3000;
        for (int i = 0; i < kWays; ++i) {
            const Vec3 from(random.next_float(), random.next_float(), 0);
            const Vec3 to(random.next_float(), random.next_float(), 1);
            const Ray way{from, (to - from).normalized(), (to - from).length()};
            double sum = 0;
            for (int k = 0; k < kSteps; ++k) {
                const float t = (static_cast<float>(k) + 0.5F) / kSteps * way.length;
                sum += static_cast<double>(cloud_at(shape, way.origin + way.direction * t));
            }
            sum *= static_cast<double>(way.length) / kSteps;
            const double error = static_cast<double>(grid.amount(way)) - sum;
            all += sum;
            excess += error;
            square += error * error;
        }
        const double deviation = std::sqrt(square / kWays) / (all / kWays);
        EXPECT_LT(deviation, is_large ? 0.03 : 0.013);
        EXPECT_NEAR(excess / all, 0, 0.006);
        RecordProperty(is_large ? "bias_of_two" : "bias_of_one", std::to_string(excess / all));
    }
}

}  // namespace
}  // namespace sunfleck::engine
