// Laws that every density keeps, over all examples: amounts are integrals of the density, and
// distances invert them.
#include "laws/density_examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sunfleck::engine {
namespace {

using namespace test;

constexpr int kWays = 60;

class DensityLaws : public testing::TestWithParam<DensityExample> {
protected:
    const Density& density() const { return GetParam().density; }
    /// Returns a point within the box: of planes that may be borders of cells, or any.
    Vec3 point() {
        const auto coordinate = [&] {
            const double u = static_cast<double>(random_.next_float());
            return random_.next_float() < 0.2F ? std::ceil(3 * u) / 4 : u;
        };
        const Vec3d p(coordinate(), coordinate(), coordinate());
        return Vec3(Affine(GetParam().box_to_world).point(p));
    }
    /// Returns ways through the box: from within and from outside, along its axes, through its
    /// corners.
    std::vector<Ray> ways() {
        std::vector<Ray> all;
        const Affine box(GetParam().box_to_world);
        const auto size = static_cast<float>((box.x + box.y + box.z).length());
        for (int i = 0; i < kWays; ++i) {
            Ray way{point(), (point() - point()).normalized(), size * random_.next_float()};
            if (i % 3 == 1) way.direction = Vec3((i % 2 == 0 ? box.x : -box.z).normalized());
            if (i % 4 < 2) {
                way.origin = way.origin - way.direction * (2 * size);
                way.length = i % 4 == 0 ? kInfinity : 3 * size;
            }
            if (way.direction.length2() > 0.5F) all.push_back(way);
        }
        all.push_back({Vec3(box.origin), Vec3((box.x + box.y + box.z).normalized())});
        return all;
    }
    static Ray part(const Ray& way, float begin, float end) {
        return {way.origin + way.direction * begin, way.direction, end - begin};
    }
    /// Returns an error that rounding may cause: of floats of that size, and of distances.
    float rounding(const Ray& way, float value) const {
        const Vec3 to = way.origin + way.direction * std::min(way.length, 1e6F);
        const float place =
            way.origin.length() + (way.length < kInfinity ? to.length() : way.origin.length());
        return 4e-6F * value + 4e-7F * place * greatest(density());
    }

    RandomStream random_{7, Purpose::test, 0, 0};
};

TEST(DensityExamples, cover_every_kind) {
    std::set<std::size_t> kinds;
    for (const DensityExample& example : density_examples()) kinds.insert(example.density.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Density>);
}

/// Would see an error of 1e-4 of the amount, or a cell that is left out or counted twice.
TEST_P(DensityLaws, amount_is_the_integral_of_the_density) {
    constexpr int kSteps = 20000;
    for (const Ray& way : ways()) {
        const Affine box(GetParam().box_to_world);
        const double size = (box.x + box.y + box.z).length();
        const double length = std::min(static_cast<double>(way.length), 4 * size);
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            const Vec3d along = Vec3d(way.direction) * ((i + 0.5) / kSteps * length);
            sum += static_cast<double>(density_at(density(), Vec3(Vec3d(way.origin) + along)));
        }
        const auto expected = static_cast<float>(sum * length / kSteps);
        const float step = static_cast<float>(length / kSteps) * greatest(density());
        EXPECT_NEAR(amount(density(), way), expected, rounding(way, expected) + step);
    }
}

TEST_P(DensityLaws, distance_inverts_amount) {
    for (const Ray& way : ways()) {
        const float whole = amount(density(), way);
        for (int i = 0; i < 20 && whole > 0; ++i) {
            const float wanted = whole * random_.next_float();
            const float distance = distance_at(density(), way, wanted);
            ASSERT_GE(distance, 0);
            ASSERT_LE(distance, way.length);
            const float ulp = 1.2e-7F * distance * greatest(density());
            EXPECT_NEAR(amount(density(), part(way, 0, distance)), wanted, 1e-6F * whole + ulp);
        }
    }
}

TEST_P(DensityLaws, a_distance_has_density_around_it) {
    for (const Ray& way : ways()) {
        const float whole = amount(density(), way);
        if (!(whole > 0)) continue;
        for (const float wanted : {0.0F, whole / 2, whole, 2 * whole}) {
            const float distance = distance_at(density(), way, wanted);
            const float near = 1e-3F * distance + 1e-3F;
            Ray around = part(way, std::max(0.0F, distance - near), distance + near);
            EXPECT_GT(amount(density(), around), 0) << wanted << " of " << whole;
        }
    }
}

TEST_P(DensityLaws, amounts_of_two_parts_add_up) {
    for (const Ray& way : ways()) {
        const float whole = amount(density(), way);
        const float length = distance_at(density(), way, 2 * whole);
        const float middle = length * random_.next_float();
        const float sum = amount(density(), part(way, 0, middle)) +
                          amount(density(), part(way, middle, way.length));
        EXPECT_NEAR(sum, whole, rounding(way, whole));
    }
}

TEST_P(DensityLaws, amount_does_not_fall) {
    for (Ray way : ways()) {
        const float whole = amount(density(), way);
        const float end = distance_at(density(), way, 2 * whole);
        float before = 0;
        for (int i = 0; i <= 100; ++i) {
            way.length = end * static_cast<float>(i) / 100;
            const float here = amount(density(), way);
            EXPECT_GE(here, before - 1e-6F * whole);
            before = here;
        }
        EXPECT_NEAR(before, whole, rounding(way, whole));
    }
}

TEST_P(DensityLaws, a_way_has_the_same_amount_backwards) {
    for (const Ray& way : ways()) {
        if (!(way.length < kInfinity)) continue;
        const Ray back{way.origin + way.direction * way.length, -way.direction, way.length};
        const float forward = amount(density(), way);
        EXPECT_NEAR(amount(density(), back), forward, rounding(way, forward));
    }
}

TEST_P(DensityLaws, nothing_is_outside) {
    const Affine box(GetParam().box_to_world);
    const Vec3d middle = box.point(Vec3d(0.5));
    const double radius = (box.x + box.y + box.z).length();
    for (int i = 0; i < kWays; ++i) {
        const Vec3d away = Vec3d(point() - point()).normalized();
        const Vec3 beyond(middle + away * radius * 2);
        EXPECT_EQ(density_at(density(), beyond), 0);
        EXPECT_EQ(amount(density(), {beyond, Vec3(away)}), 0);
        const Vec3d across = away.cross(Vec3d(0.6, 0.8, 0)).normalized();
        EXPECT_EQ(amount(density(), {beyond, Vec3(across)}), 0);
    }
}

TEST_P(DensityLaws, the_greatest_is_nowhere_exceeded_and_the_mean_is_less) {
    float most = 0;
    double sum = 0;
    constexpr int kPoints = 40000;
    for (int i = 0; i < kPoints; ++i) {
        const Vec3d u(random_.next_float(), random_.next_float(), random_.next_float());
        const Vec3 p(Affine(GetParam().box_to_world).point(u));
        most = std::max(most, density_at(density(), p));
        sum += static_cast<double>(density_at(density(), p));
    }
    EXPECT_LE(most, greatest(density()) * 1.000001F);
    // Six standard errors, each at most half of the greatest by the root of the number.
    EXPECT_NEAR(mean(density()), sum / kPoints, 0.015 * static_cast<double>(greatest(density())));
}

TEST_P(DensityLaws, a_moved_density_is_the_same_elsewhere) {
    const Vec3d by(16, -8, 32);
    const Density there = moved(density(), by);
    for (const Ray& way : ways()) {
        const Ray moved_way{way.origin + Vec3(by), way.direction, way.length};
        const float whole = amount(density(), way);
        EXPECT_NEAR(amount(there, moved_way), whole, 20 * rounding(way, whole));
    }
}

INSTANTIATE_TEST_SUITE_P(All, DensityLaws, testing::ValuesIn(density_examples()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine
