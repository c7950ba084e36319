// The tree does not depend on the number of threads that build it; devices are checked.
#include "geometry/embree.h"

#include "core/parallel.h"
#include "support.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sunfleck::engine {
namespace {

using test::Dice;

/// Many equal distances: a grid whose every triangle is there twice, seen along its edges too.
TriangleMesh doubled_grid(std::uint32_t n) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t j = 0; j <= n; ++j)
            mesh.positions.emplace_back(static_cast<float>(i), static_cast<float>(j), 0.0F);
    for (int copy = 0; copy < 2; ++copy)
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const std::uint32_t a = i * (n + 1) + j;
                mesh.triangles.push_back({a, a + 1, a + n + 1});
                mesh.triangles.push_back({a + 1, a + n + 2, a + n + 1});
            }
    return mesh;
}

std::vector<std::uint32_t> primitives_seen(std::size_t threads) {
    const ThreadLimit limit(threads);
    constexpr std::uint32_t kSize = 300;
    const Geometry geometry = test::of_one(doubled_grid(kSize));
    Dice dice(50);
    std::vector<std::uint32_t> seen;
    for (int i = 0; i < 60000; ++i) {
        const auto x = static_cast<float>(dice.below(kSize + 1)) + (i % 3 == 1 ? 0.5F : 0);
        const auto y = static_cast<float>(dice.below(kSize + 1)) + (i % 3 == 2 ? 0.25F : 0);
        const auto hit = geometry.intersect({{x, y, 5}, {0, 0, -1}});
        seen.push_back(hit ? hit->primitive : kNone);
    }
    return seen;
}

TEST(Embree, the_number_of_threads_that_build_does_not_show) {
    const auto one = primitives_seen(1);
    EXPECT_GT(std::count_if(one.begin(), one.end(), [](auto p) { return p != kNone; }), 50000);
    EXPECT_EQ(one, primitives_seen(2));
    EXPECT_EQ(one, primitives_seen(0));
}

TEST(Embree, an_unknown_instruction_set_is_refused_with_a_remedy) {
    try {
        const Geometry geometry({}, "avx3");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "unknown instruction set \"avx3\" for the geometry; use \"avx2\" or \"native\"");
    }
}

TEST(Embree, native_kernels_find_the_same_surface) {
    GeometryInput input;
    input.shapes.push_back({test::bumpy_ball(20, 0.1, true), Matrix(), false});
    input.in_world = {0};
    const Geometry promised(input, "avx2");
    const Geometry native(std::move(input), "native");
    Dice dice(51);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = test::ray_between(dice.direction() * 3, dice.in_box(0.7));
        const auto a = promised.intersect(ray);
        const auto b = native.intersect(ray);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) {
            EXPECT_LT((a->position - b->position).length(), 1e-5);
        }
    }
}

}  // namespace
}  // namespace sunfleck::engine
