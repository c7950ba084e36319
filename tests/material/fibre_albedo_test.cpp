// The energy of a hair: nothing is lost in a clear one, and a path traced by hand agrees.
#include "material/fibre_albedo.h"

#include "bsdf/fresnel.h"
#include "core/random.h"
#include "math/warp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

float all_of(float absorption, float eta = 1.55F) {
    const FibreAlbedo albedo = fibre_albedo(absorption, eta);
    return albedo.back + albedo.through;
}

TEST(FibreAlbedo, clear_fibres_lose_nothing) {
    for (const float eta : {1.0F, 1.33F, 1.55F, 2.0F}) EXPECT_NEAR(all_of(0, eta), 1, 1e-5) << eta;
    EXPECT_NEAR(fibre_albedo(0, 1).through, 1, 1e-5);
}

TEST(FibreAlbedo, falls_to_what_the_surface_reflects) {
    float before = 1;
    for (const float absorption : {0.02F, 0.1F, 0.5F, 2.0F, 10.0F, 100.0F}) {
        EXPECT_LT(all_of(absorption), before);
        before = all_of(absorption);
    }
    EXPECT_LT(fibre_albedo(1000, 1.55F).through, 0.001);
    EXPECT_NEAR(fibre_albedo(1000, 1.55F).back, before, 0.002);
}

/// Light through a circle in three dimensions: rays that refract and reflect at its wall, one by
/// one. @return shares of the first crossing's end, and of all else.
FibreAlbedo traced(float absorption, float eta, int rays) {
    RandomStream numbers(7, Purpose::test, 0, 0);
    const auto number = [&] { return static_cast<float>(numbers.next()); };
    FibreAlbedo sum;
    for (int i = 0; i < rays;) {
        // Evenly from everywhere: a random direction, kept as the fibre is wide from there.
        const float sine = 2 * number() - 1;
        const float cosine = std::sqrt(1 - sine * sine);
        if (number() > cosine) continue;
        ++i;
        const float h = 2 * number() - 1;
        // The circle's axis is z; the ray comes along -x at height h.
        const Vec3 normal(std::sqrt(1 - h * h), h, 0);
        const Vec3 in(-cosine, 0, sine);
        const float c = -in.dot(normal);
        const float far = std::sqrt(1 - (1 - c * c) / (eta * eta));
        const Vec3 inside = (in / eta + normal * (c / eta - far)).normalized();
        const float reflected = dielectric_reflectance(c, eta);
        const float across = std::sqrt(inside.x * inside.x + inside.y * inside.y);
        const float chord = -2 * (normal.x * inside.x + normal.y * inside.y) / (across * across);
        const float left = std::exp(-absorption * chord);
        sum.back += reflected;
        float carried = (1 - reflected) * left;
        sum.through += carried * (1 - reflected);
        for (int k = 0; k < 50; ++k) {
            carried *= reflected * left;
            sum.back += carried * (1 - reflected);
        }
    }
    const auto count = static_cast<float>(rays);
    return {sum.back / count, sum.through / count};
}

TEST(FibreAlbedo, agrees_with_rays) {
    for (const float absorption : {0.05F, 0.4F, 2.0F}) {
        const FibreAlbedo expected = traced(absorption, 1.55F, 60'000);
        const FibreAlbedo albedo = fibre_albedo(absorption, 1.55F);
        EXPECT_NEAR(albedo.back, expected.back, 0.004) << absorption;
        EXPECT_NEAR(albedo.through, expected.through, 0.004) << absorption;
    }
}

/// pbrt-v4's colours of hair are absorptions and back.
TEST(FibreAlbedo, absorption_of_colours) {
    EXPECT_EQ(absorption_of_hair(1, 0.3F), 0);
    EXPECT_NEAR(absorption_of_hair(0.5F, 0.3F), 0.0138565F, 1e-6);
    EXPECT_GT(absorption_of_hair(0.1F, 0.3F), absorption_of_hair(0.2F, 0.3F));
}

}  // namespace
}  // namespace sunfleck::engine
