// Emission guides: their images have the density that they say, and lie where they should.
#include "guide/emission_guide.h"

#include "chains/target.h"
#include "core/random.h"
#include "guide/guided_points.h"
#include "math/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace sunfleck::engine {
namespace {

using Points = std::vector<WeightedEmission>;

/// Points of a box of side `width` around 0.3 in the dimensions of `narrow`, anywhere in the
/// others.
Points around(double width, const std::vector<std::size_t>& narrow, std::size_t count = 4000) {
    RandomStream random(1, Purpose::test, 0, 0);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        WeightedEmission& p = points.emplace_back();
        for (double& x : p.point) x = random.next();
        for (const std::size_t s : narrow) p.point.at(s) = 0.3 + (p.point.at(s) - 0.5) * width;
    }
    return points;
}

bool is_inside(const EmissionPoint& p, double width, const std::vector<std::size_t>& narrow) {
    return std::all_of(narrow.begin(), narrow.end(),
                       [&](std::size_t s) { return std::abs(p.at(s) - 0.3) <= width / 2; });
}

EmissionPoint uniform(RandomStream& random) {
    EmissionPoint u;
    for (double& x : u) x = random.next();
    return u;
}

/// Off the middle line of a slanted tube, which dimensions 0 and 1 run along.
double off_line(const EmissionPoint& p, std::size_t s) {
    return p.at(s) - (0.4 + 0.7 * (p[0] - 0.3) - 0.3 * (p[s - 2] - 0.3));
}

/// Points of a tube: a square of side .4 times the tube's width, in dimensions 2 and 3.
Points tube(double width, std::size_t count = 4000) {
    Points points = around(0.4, {0, 1}, count);
    for (WeightedEmission& p : points)
        for (const std::size_t s : {2U, 3U})
            p.point.at(s) = width * (p.point.at(s) - 0.5) + p.point.at(s) - off_line(p.point, s);
    return points;
}

/// What is measured in every map: one that is broad, narrow, thin in one dimension, of two
/// clusters, of a slanted tube, and cut down to where trials were visible.
std::vector<EmissionGuide> maps() {
    Points two = around(0.01, {0, 1});
    for (std::size_t i = 0; i < two.size(); i += 3) {
        two[i].point[0] += 0.5;
        two[i].weight = 5;
    }
    std::vector<EmissionGuide> all = {EmissionGuide::learned(around(0.5, {0, 1}), {0.25}),
                                      EmissionGuide::learned(around(0.02, {0, 3}), {0.5}),
                                      EmissionGuide::learned(around(0.1, {4}), {0.1}),
                                      EmissionGuide::learned(two, {0.25}),
                                      EmissionGuide::learned(tube(0.01), {0.25})};
    std::vector<EmissionGuide::Trial> trials;
    for (const WeightedEmission& p : two) trials.push_back({p.point, p.point[2] < 0.5});
    for (const WeightedEmission& p : tube(0.01)) trials.push_back({p.point, p.point[0] < 0.3});
    all.push_back(all[3].where_visible(trials, 0.05));
    all.push_back(all[4].where_visible(trials, 0.05));
    all.push_back(all[3].widened(0.1));
    std::vector<EmissionGuide::Worth> worth;
    for (const WeightedEmission& p : two) worth.push_back({p.point, p.point[2] < 0.5 ? 9.0 : 1.0});
    const EmissionGuide::Growth growth{0.05, 4, 0.01};
    all.push_back(EmissionGuide::learned(two, growth).by_worth(worth, 0.3, growth));
    all.push_back(all[0].mixed_with(std::make_shared<const EmissionGuide>(all[4]), 0.2));
    all.push_back(EmissionGuide().mixed_with(std::make_shared<const EmissionGuide>(all[3]), 0.7));
    return all;
}

// 200,000 points a guide: the mean of f / density over images is the integral of f over what is
// covered, which uniform points tell; differences below five standard errors.
TEST(EmissionGuide, images_have_the_density_that_they_say) {
    for (const EmissionGuide& map : maps()) {
        RandomStream random(2, Purpose::test, 0, 0);
        const auto f = [](const EmissionPoint& p) {
            return 1 + 2 * p[0] + p[1] * p[4] + p[2] * p[3];
        };
        RunningMean by_map;
        RunningMean by_uniform;
        for (int i = 0; i < 200'000; ++i) {
            const EmissionGuide::Image image = map(uniform(random));
            for (const double x : image.point) ASSERT_TRUE(x >= 0 && x <= 1);
            ASSERT_EQ(map.density(image.point), image.density);
            by_map.add(f(image.point) / image.density);
            const EmissionPoint u = uniform(random);
            by_uniform.add(map.covers(u) ? f(u) : 0);
        }
        EXPECT_NEAR(by_map.mean(), by_uniform.mean(),
                    5 * std::hypot(by_map.standard_error(), by_uniform.standard_error()))
            << map.boxes();
    }
}

TEST(EmissionGuide, most_images_lie_where_the_points_did) {
    for (const double width : {0.3, 1e-2, 1e-4, 1e-6}) {
        const EmissionGuide map = EmissionGuide::learned(around(width, {0, 1}), {0.25});
        RandomStream random(3, Purpose::test, 0, 0);
        int inside = 0;
        for (int i = 0; i < 10'000; ++i)
            inside += is_inside(map(uniform(random)).point, 1.3 * width, {0, 1}) ? 1 : 0;
        EXPECT_GT(inside, 6000) << width;
        EXPECT_LT(map.boxes(), 400U) << width;
    }
}

// Boxes along the tube would be 40 and 400 by 40 and 400.
TEST(EmissionGuide, follows_a_slanted_tube) {
    for (const double width : {1e-2, 1e-3}) {
        const EmissionGuide map = EmissionGuide::learned(tube(width), {0.25});
        EXPECT_GE(map.shears(), 2U);
        RandomStream random(6, Purpose::test, 0, 0);
        int inside = 0;
        for (int i = 0; i < 10'000; ++i) {
            const EmissionPoint p = map(uniform(random)).point;
            const bool is_near =
                std::abs(off_line(p, 2)) < 0.65 * width && std::abs(off_line(p, 3)) < 0.65 * width;
            inside += is_near && is_inside(p, 0.5, {0, 1}) ? 1 : 0;
        }
        EXPECT_GT(inside, 6000) << width;
        EXPECT_LT(map.boxes(), 400U) << width;
    }
}

/// Whatever the one guide says, a mixture has its share of the other.
TEST(EmissionGuide, mixture_keeps_what_either_knows) {
    const EmissionGuide::Growth growth{0.05, 4, 0.01};
    const auto wide =
        std::make_shared<const EmissionGuide>(EmissionGuide::learned(around(0.3, {0, 1}), growth));
    const EmissionGuide narrow = EmissionGuide::learned(around(1e-3, {0, 1}), growth);
    const EmissionGuide mixture = narrow.mixed_with(wide, 0.1);
    RandomStream random(9, Purpose::test, 0, 0);
    int in_narrow = 0;
    for (int i = 0; i < 20'000; ++i) {
        const EmissionPoint p = mixture(uniform(random)).point;
        ASSERT_GE(mixture.density(p), 0.1 * wide->density(p));
        if (is_inside(p, 1.3e-3, {0, 1})) ++in_narrow;
    }
    EXPECT_GT(in_narrow, 0.75 * 20'000);
    EXPECT_LT(in_narrow, 0.92 * 20'000);
}

/// Two halves of a square, alike in samples: trials of one are worth four times those of the other,
/// so its density is four times as large, but for the shares that do not follow worth.
TEST(EmissionGuide, density_follows_the_root_of_the_mean_squared_worth) {
    const auto is_right = [](const EmissionPoint& p) { return p[0] > 0.3; };
    const EmissionGuide::Growth growth{0.01, 4, 0};
    Points points = around(0.2, {0, 1}, 20'000);
    std::vector<EmissionGuide::Worth> trials;
    for (WeightedEmission& p : points) {
        trials.push_back({p.point, is_right(p.point) ? 16.0 : 1.0});
        p.weight = is_right(p.point) ? 16 : 1;  // for a cut between the halves
    }
    const EmissionGuide guide =
        EmissionGuide::learned(points, growth).by_worth(trials, 0.01, growth);
    RandomStream random(7, Purpose::test, 0, 0);
    int right = 0;
    int left = 0;
    for (int i = 0; i < 20'000; ++i) {
        const EmissionPoint p = guide(uniform(random)).point;
        if (is_inside(p, 0.2, {0, 1})) ++(is_right(p) ? right : left);
    }
    EXPECT_NEAR(static_cast<double>(right) / left, 4, 0.6);
}

/// Points of a small square are of worth, a thousand trials around it are not: whatever the size of
/// what lies around, most of the mass follows worth.
TEST(EmissionGuide, worth_is_not_diluted_by_what_lies_around) {
    const EmissionGuide::Growth growth{0.05, 4, 0.01};
    for (const double width : {0.3, 1e-2, 1e-4}) {
        const Points points = around(width, {0, 1}, 2'000);
        std::vector<EmissionGuide::Worth> trials;
        for (const WeightedEmission& p : points) trials.push_back({p.point, 1});
        RandomStream random(8, Purpose::test, 0, 0);
        for (int i = 0; i < 1'000; ++i) trials.push_back({uniform(random), 0});
        const EmissionGuide guide =
            EmissionGuide::learned(points, growth).by_worth(trials, 0.3, growth);
        int inside = 0;
        for (int i = 0; i < 10'000; ++i)
            if (is_inside(guide(uniform(random)).point, width, {0, 1})) ++inside;
        EXPECT_GT(inside, 7'000) << width;
    }
}

/// Where nothing was found beside where much was, density falls by degrees.
TEST(EmissionGuide, spread_reaches_what_lies_beside) {
    const Points points = around(1e-3, {0, 1}, 20'000);
    const EmissionPoint beside = {0.3007, 0.3, 0.5, 0.5, 0.5};
    const EmissionGuide without = EmissionGuide::learned(points, {0.05, 4, 0});
    const EmissionGuide with = EmissionGuide::learned(points, {0.05, 4, 0.01});
    EXPECT_GT(with.density(beside), 20 * without.density(beside));
    EXPECT_GT(with.density({0.3, 0.3, 0.5, 0.5, 0.5}),
              0.5 * without.density({0.3, 0.3, 0.5, 0.5, 0.5}));
}

TEST(EmissionGuide, is_nowhere_zero_unless_it_is_asked_to_be) {
    const EmissionGuide map = EmissionGuide::learned(around(1e-3, {0, 1}), {0.25});
    RandomStream random(4, Purpose::test, 0, 0);
    for (int i = 0; i < 1000; ++i) EXPECT_GE(map.density(uniform(random)), 0.25 * (1 - 1e-12));
    std::vector<EmissionGuide::Trial> trials;
    for (const WeightedEmission& p : around(1e-3, {0, 1})) trials.push_back({p.point, true});
    const EmissionGuide cut = map.where_visible(trials, 0.05);
    EXPECT_FALSE(cut.covers({0.9, 0.9, 0.5, 0.5, 0.5}));
    EXPECT_TRUE(cut.covers({0.3, 0.3, 0.5, 0.5, 0.5}));
}

// Of trials that are visible one time in ten in one half, and always in the other.
TEST(EmissionGuide, where_visible_goes_by_the_root_of_how_often) {
    std::vector<EmissionGuide::Trial> trials;
    Points points = around(1, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool left = points[i].point[0] < 0.5;
        points[i].weight = left ? 1 : 4;
        trials.push_back({points[i].point, !left || i % 10 == 0});
    }
    const EmissionGuide map = EmissionGuide::learned(points, {0.25});
    ASSERT_GE(map.boxes(), 2U);
    const EmissionGuide cut = map.where_visible(trials, 0.05);
    const EmissionPoint left{0.25, 0.5, 0.5, 0.5, 0.5};
    const EmissionPoint right{0.75, 0.5, 0.5, 0.5, 0.5};
    EXPECT_NEAR(cut.density(left) / cut.density(right), std::sqrt(0.1), 0.05);
    EXPECT_FALSE(map.where_visible(trials, 0.3).covers(left));
    for (EmissionGuide::Trial& trial : trials) trial.visible = false;
    EXPECT_TRUE(map.where_visible(trials, 0.05).is_identity());
}

// A ninth of the points in one half of a slab, the others in its other half; nothing outside.
TEST(EmissionGuide, widened_goes_by_the_root_of_what_was_found) {
    Points points = around(1, {}, 9000);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].point[0] = 0.25 + points[i].point[0] / 16 + (i % 9 == 0 ? 0 : 0.0625);
    const EmissionGuide map = EmissionGuide::learned(points, {0.25});
    const EmissionGuide wide = map.widened(0);
    const auto at = [](double x) { return EmissionPoint{x, 0.5, 0.5, 0.5, 0.5}; };
    EXPECT_NEAR(wide.density(at(0.35)) / wide.density(at(0.28)), std::sqrt(8.0), 0.3);
    EXPECT_EQ(wide.density(at(0.7)), 0);
    const EmissionGuide kept = map.widened(1);
    EXPECT_NEAR(kept.density(at(0.35)) / kept.density(at(0.28)),
                map.density(at(0.35)) / map.density(at(0.28)), 1e-9);
    EXPECT_EQ(kept.density(at(0.7)), 0);
}

TEST(EmissionGuide, without_points_it_is_the_identity) {
    const EmissionGuide map = EmissionGuide::learned({}, {0.25});
    EXPECT_TRUE(map.is_identity());
    const EmissionPoint p{0.1, 0.2, 0.3, 0.4, 0.5};
    EXPECT_EQ(map(p).point, p);
    EXPECT_EQ(map(p).density, 1);
    EXPECT_TRUE(map.covers(p));
}

// A box must hold many numbers of a dimension, or a rounded image could fall out of its box.
TEST(EmissionGuide, equal_points_do_not_make_boxes_too_small) {
    const EmissionGuide map = EmissionGuide::learned(around(0, {0, 1}), {0.25});
    RandomStream random(5, Purpose::test, 0, 0);
    for (int i = 0; i < 10'000; ++i) {
        const EmissionGuide::Image image = map(uniform(random));
        EmissionPoint rounded;
        for (std::size_t s = 0; s < kGuidedDimensions; ++s)
            rounded[s] = to_unit(to_fraction(image.point[s]));
        ASSERT_EQ(map.density(rounded), image.density);
    }
}

// Mapped paths have the emission that the guide says, and weigh one over its density.
TEST(GuidedPoints, weigh_what_they_should) {
    const EmissionGuide map = EmissionGuide::learned(around(0.05, {0, 1}), {0.25});
    const PassId pass{1, 2};
    const PassId beside = pass.with_stratum(PassId::kStrata / 2);
    const GuidedPoints points(pass, map);
    RunningMean volume;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        auto read = points.path(i);
        StoredSample sample;
        for (std::uint32_t s = 0; s < 8; ++s) sample.set(s, read(s));
        ASSERT_EQ(read.weight(), 1 / map.density(emission_of(sample)));
        volume.add(read.weight());
        EXPECT_EQ(sample[7], EmissionPoints(beside).path(i)(7));
        EXPECT_NE(sample[7], EmissionPoints(pass).path(i)(7));
    }
    EXPECT_NEAR(volume.mean(), 1, 0.02);
}

}  // namespace
}  // namespace sunfleck::engine
