// The light tree: probabilities of what is chosen, no light forgotten that can arrive, and how
// near its choice comes to what arrives.
#include "light/light_tree.h"

#include "core/random.h"
#include "laws/light_examples.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace sunfleck::engine {
namespace {

using namespace testing_support;

/// Small triangles in a room, turned at random; every seventh two-sided. With all examples of
/// other lights among them, and one without power.
std::vector<Light> many_lights(int count) {
    std::vector<Light> lights;
    RandomStream random(11, Purpose::test, 0, 0);
    const auto anywhere = [&] {
        return Vec3d(20 * random.next(), 20 * random.next(), 5 * random.next());
    };
    for (int i = 0; i < count; ++i) {
        EmittingTriangle t{anywhere(), {}, {}, {}};
        t.edge1 = uniform_sphere({random.next(), random.next()}) * 0.3;
        t.edge2 = t.edge1.cross(uniform_sphere({random.next(), random.next()}));
        t.normal = t.edge1.cross(t.edge2).normalized();
        AreaLight light{Spectrum::constant(0.5F + random.next_float()), t, i % 7 == 0};
        lights.emplace_back(light);
    }
    for (const LightExample& example : light_examples()) {
        lights.push_back(example.make());
        std::visit([](auto& l) { l.curve = Spectrum::constant(1); }, lights.back());
    }
    lights.emplace_back(PointLight{{}, Vec3d(0)});
    return lights;
}

std::vector<double> weights_of(const std::vector<Light>& lights) {
    std::vector<double> weights;
    weights.reserve(lights.size());
    for (const Light& light : lights)
        weights.push_back(power(light, kExampleSphere) *
                          static_cast<double>(curve(light).luminance()));
    return weights;
}

Receiver random_receiver(RandomStream& random, int i) {
    Receiver at;
    at.position = {20 * random.next_float(), 20 * random.next_float(), 5 * random.next_float()};
    if (i % 2 == 0) at.normal = Vec3(uniform_sphere({random.next(), random.next()}));
    return at;
}

/// A lamp of two triangles and a sun of a thousand times their weight, or of a thousandth.
TEST(LightTree, a_lamp_keeps_its_share_beside_the_sun_and_the_sun_beside_lamps) {
    const Vec3d corner(-1, -1, 2);
    const EmittingTriangle half{corner, Vec3d(0, 2, 0), Vec3d(2, 0, 0), {0, 0, -1}};
    const EmittingTriangle other{
        -corner + Vec3d(0, 0, 4), Vec3d(0, -2, 0), Vec3d(-2, 0, 0), {0, 0, -1}};
    const Spectrum one = Spectrum::constant(1);
    const std::vector<Light> lights = {DistantLight{one, {0, 0, -1}}, AreaLight{one, half, false},
                                       AreaLight{one, other, false}};
    const Receiver below{Vec3(0), Vec3(0, 0, 1)};
    for (const double sun : {1000.0, 1.0, 1e-3}) {
        const LightTree tree(lights, {sun, 0.5, 0.5});
        const double lamp = tree.probability(below, 1) + tree.probability(below, 2);
        EXPECT_NEAR(tree.probability(below, 0) + lamp, 1, 1e-12);
        EXPECT_NEAR(lamp, std::clamp(1 / (1 + sun), 0.25, 0.75), 1e-12) << sun;
        EXPECT_EQ(tree.is_grown(), sun != 1);
    }
}

TEST(LightTree, nothing_that_shines_is_nothing_to_choose) {
    for (const std::vector<double>& weights : {std::vector<double>{}, std::vector<double>{0, 0}}) {
        const std::vector<Light> lights(weights.size(), PointLight{{}, Vec3d(0)});
        EXPECT_FALSE(LightTree(lights, weights).choose({Vec3(0), Vec3(0)}, 0.5));
    }
}

TEST(LightTree, choices_together_are_those_of_each_alone) {
    for (const int count : {0, 3, 300}) {
        const std::vector<Light> lights = many_lights(count);
        const LightTree tree(lights, weights_of(lights));
        RandomStream random(8, Purpose::test, 0, static_cast<std::uint32_t>(count));
        int some = 0;
        for (int i = 0; i < 500; ++i) {
            const Receiver at = random_receiver(random, i);
            std::vector<double> numbers(static_cast<std::size_t>(i % 9));
            for (double& u : numbers) u = random.next();
            std::sort(numbers.begin(), numbers.end());
            std::vector<double> changed = numbers;
            std::vector<std::optional<LightChoice::Chosen>> chosen(numbers.size());
            tree.choose_each(at, changed, chosen);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                const auto alone = tree.choose(at, numbers[k]);
                ASSERT_EQ(chosen[k].has_value(), alone.has_value()) << i << ' ' << k;
                if (!alone) continue;
                ++some;
                EXPECT_EQ(chosen[k]->index, alone->index);
                EXPECT_EQ(chosen[k]->probability, alone->probability);
                const double probability = tree.probability(at, alone->index);
                EXPECT_NEAR(alone->probability, probability, 1e-12 * probability);
            }
        }
        EXPECT_GT(some, 1000);
    }
}

TEST(LightTree, probabilities_sum_to_one_and_are_those_of_choose) {
    const std::vector<Light> lights = many_lights(300);
    const LightTree tree(lights, weights_of(lights));
    RandomStream random(1, Purpose::test, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const Receiver at = random_receiver(random, i);
        double sum = 0;
        for (std::size_t l = 0; l < lights.size(); ++l) sum += tree.probability(at, l);
        // Branches behind which nothing can arrive are ends, too.
        EXPECT_LE(sum, 1 + 1e-9);
        EXPECT_GT(sum, i % 2 == 0 ? 0.1 : 0.9);
        for (int k = 0; k < 200; ++k) {
            const auto chosen = tree.choose(at, random.next());
            if (!chosen) continue;
            ASSERT_GT(chosen->probability, 0);
            ASSERT_DOUBLE_EQ(chosen->probability, tree.probability(at, chosen->index));
        }
    }
    EXPECT_EQ(tree.probability({}, lights.size() - 1), 0);  // of no power
}

/// As often as said: 12 lights around a point, in 100,000 even steps of u.
TEST(LightTree, chooses_as_often_as_its_probabilities_say) {
    std::vector<Light> lights = many_lights(12);
    lights.resize(12);
    lights.emplace_back(InfiniteLight{Spectrum::constant(1e-4F)});
    const LightTree tree(lights, weights_of(lights));
    constexpr int kSteps = 100000;
    const Receiver at{{7, 8, 2}, {0, 0, 1}};
    std::vector<double> counts(lights.size(), 0.0);
    for (int i = 0; i < kSteps; ++i)
        if (const auto chosen = tree.choose(at, (i + 0.5) / kSteps)) counts[chosen->index] += 1;
    for (std::size_t l = 0; l < lights.size(); ++l)
        EXPECT_NEAR(counts[l] / kSteps, tree.probability(at, l), 2e-5) << l;
    EXPECT_NEAR(tree.probability(at, 12), 0.25, 1e-12);
}

/// What a light brings to a point, by 8 x 8 samples of it.
double arriving(const Light& light, const Receiver& at) {
    double sum = 0;
    for (int i = 0; i < 64; ++i) {
        const Vec2 u((static_cast<float>(i % 8) + 0.5F) / 8,
                     (static_cast<float>(i) / 8 + 0.5F) / 8 - 0.0625F * float(i % 8) / 8);
        const auto s = sample_direct(light, at.position, u, kExampleSphere);
        if (!s) continue;
        const float cosine = at.normal == Vec3(0) ? 1 : at.normal.dot(s->direction);
        sum += static_cast<double>(s->factor * std::max(cosine, 0.0F)) / 64;
    }
    return sum * static_cast<double>(curve(light).luminance());
}

TEST(LightTree, no_light_is_forgotten_that_arrives) {
    const std::vector<Light> lights = many_lights(200);
    const LightTree tree(lights, weights_of(lights));
    RandomStream random(2, Purpose::test, 0, 0);
    int arrived = 0;
    for (int i = 0; i < 60; ++i) {
        const Receiver at = random_receiver(random, i);
        for (std::size_t l = 0; l < lights.size(); ++l) {
            if (!(arriving(lights[l], at) > 1e-9)) continue;
            ++arrived;
            ASSERT_GT(tree.probability(at, l), 0) << l << ' ' << lights[l].index();
        }
    }
    EXPECT_GT(arrived, 4000);
}

/// Sum of arriving^2 / probability, over that by power: the second moment of one sample. Means of
/// the sums agree, since no light is forgotten.
TEST(LightTree, chooses_what_arrives) {
    std::vector<Light> lights = many_lights(1000);
    lights.resize(1000);
    const std::vector<double> weights = weights_of(lights);
    const LightTree tree(lights, weights);
    const LightChoice by_power(weights);
    RandomStream random(3, Purpose::test, 0, 0);
    double ratio = 0;
    constexpr int kPoints = 40;
    for (int i = 0; i < kPoints; ++i) {
        const Receiver at = random_receiver(random, 2 * i);
        double by_tree = 0;
        double plain = 0;
        for (std::size_t l = 0; l < lights.size(); ++l) {
            const double light = arriving(lights[l], at);
            if (!(light > 0)) continue;
            by_tree += light * light / std::max(tree.probability(at, l), 1e-30);
            plain += light * light / by_power.probability(l);
        }
        ratio += by_tree / plain / kPoints;
    }
    RecordProperty("ratio", std::to_string(ratio));
    EXPECT_LT(ratio, 0.3) << ratio;
}

TEST(LightTree, of_one_light_takes_it_and_of_none_nothing) {
    const std::vector<Light> one = {PointLight{Spectrum::constant(1), Vec3d(0, 0, 1)}};
    const LightTree tree(one, {3});
    const auto chosen = tree.choose({{1, 2, 3}, {0, 0, 1}}, 0.7);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->index, 0U);
    EXPECT_EQ(chosen->probability, 1);
    EXPECT_FALSE(LightTree().choose({}, 0.5));
    EXPECT_FALSE(LightTree(one, {0}).choose({}, 0.5));
    // Any number of lights at one place, and points right there.
    const std::vector<Light> same(100, one[0]);
    const LightTree pile(same, std::vector<double>(100, 1));
    EXPECT_NEAR(pile.probability({{0, 0, 1}, Vec3(0)}, 3), 0.01, 0.005);
    EXPECT_NEAR(pile.probability({{5, 0, 1}, Vec3(0)}, 3), 0.01, 0.005);
}

}  // namespace
}  // namespace sunfleck::engine
