// Pixel filters: their values, and samples drawn as |f| with weights that restore f.
//
// Chi-square at significance 1e-3 each over 2^18 samples in 40 bins an axis; sees a density off
// by 2% over half the axis. Means of weights: over fixed grids, no randomness.
#include "camera/filter.h"

#include "core/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace sunfleck::engine {
namespace {

using testing_support::chi_square_p;

FilterSettings settings(FilterKind kind, const Vec2d& radius) {
    FilterSettings filter;
    filter.kind = kind;
    filter.radius = radius;
    return filter;
}

const std::vector<FilterSettings>& examples() {
    static const std::vector<FilterSettings> all = {
        settings(FilterKind::box, {0.5, 0.7}),      settings(FilterKind::triangle, {2, 1}),
        settings(FilterKind::gaussian, {1.5, 1.5}), settings(FilterKind::gaussian, {1, 3}),
        settings(FilterKind::mitchell, {2, 2}),     settings(FilterKind::mitchell, {1, 3}),
        settings(FilterKind::sinc, {4, 4}),         settings(FilterKind::sinc, {2.3, 1.1})};
    return all;
}

/// A picture that is a product, as the filters are: their integrals are products, too.
struct Picture {
    std::function<double(double)> x;
    std::function<double(double)> y;
};

/// Integral of picture * f over that of f, by the midpoint rule along each axis.
double filtered(const FilterSettings& filter, const Picture& picture) {
    constexpr int kPoints = 1 << 16;
    Vec2d with(0);
    Vec2d without(0);
    for (int i = 0; i < kPoints; ++i) {
        const double place = (i + 0.5) / kPoints * 2 - 1;
        const Vec2d at = filter.radius * place;
        const Vec2d f(filter_value(filter, {at.x, 0}), filter_value(filter, {0, at.y}));
        with += f * Vec2d(picture.x(at.x), picture.y(at.y));
        without += f;
    }
    return with.x / without.x * (with.y / without.y);
}

/// Mean of weight * picture over u: each axis over a grid of 2^18 midpoints, the other held.
double sampled(const FilterSettings& filter, const Picture& picture) {
    constexpr int kPoints = 1 << 18;
    constexpr double kHeld = 0.5003;
    const FilterSampler sampler(filter);
    double x = 0;
    double y = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double u = (i + 0.5) / kPoints;
        const FilterSample across = sampler.sample({u, kHeld});
        const FilterSample down = sampler.sample({kHeld, u});
        x += static_cast<double>(across.weight) * picture.x(across.offset.x) / kPoints;
        y += static_cast<double>(down.weight) * picture.y(down.offset.y) / kPoints;
    }
    return x * y / static_cast<double>(sampler.sample({kHeld, kHeld}).weight);
}

TEST(Filter, integrals_are_those_of_sums) {
    for (const FilterSettings& filter : examples()) {
        constexpr int kSteps = 1500;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j)
                sum += filter_value(filter, {((i + 0.5) / kSteps * 2 - 1) * filter.radius.x,
                                             ((j + 0.5) / kSteps * 2 - 1) * filter.radius.y});
        sum *= 4 * filter.radius.x * filter.radius.y / kSteps / kSteps;
        EXPECT_NEAR(filter_integral(filter) / sum, 1, 1e-4);
    }
}

TEST(Filter, weights_have_mean_one) {
    const auto white = [](double) { return 1.0; };
    for (const FilterSettings& filter : examples())
        EXPECT_NEAR(sampled(filter, {white, white}), 1, 1e-4)
            << static_cast<int>(filter.kind) << filter.radius;
}

TEST(Filter, samples_filter_a_smooth_picture_as_the_integral_does) {
    const Picture picture = {[](double x) { return std::cos(1.3 * x) + 0.3 * x; },
                             [](double y) { return std::exp(0.4 * y) + y * y; }};
    for (const FilterSettings& filter : examples())
        EXPECT_NEAR(sampled(filter, picture), filtered(filter, picture), 1e-4)
            << static_cast<int>(filter.kind) << filter.radius;
}

/// p of the hypothesis that one axis of the samples is spread as |f| along it.
double spread_p(const FilterSettings& filter, bool vertical) {
    constexpr int kBins = 40;
    constexpr int kFine = 1000;  // a bin's integral by midpoints
    constexpr int kSamples = 1 << 18;
    const double radius = vertical ? filter.radius.y : filter.radius.x;
    std::vector<double> expected(kBins, 0);
    double total = 0;
    for (int i = 0; i < kBins * kFine; ++i) {
        const double x = ((i + 0.5) / (kBins * kFine) * 2 - 1) * radius;
        const double f = std::abs(filter_value(filter, vertical ? Vec2d(0, x) : Vec2d(x, 0)));
        expected[static_cast<std::size_t>(i / kFine)] += f;
        total += f;
    }
    std::vector<int> count(kBins, 0);
    const FilterSampler sampler(filter);
    RandomStream random(3, Purpose::test, 0, vertical ? 1 : 0);
    for (int i = 0; i < kSamples; ++i) {
        const double x = random.next();
        const Vec2d offset = sampler.sample({x, random.next()}).offset;
        const double share = ((vertical ? offset.y : offset.x) / radius + 1) / 2;
        ++count.at(static_cast<std::size_t>(share * kBins));
    }
    double statistic = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double mean = expected[i] / total * kSamples;
        statistic += (count[i] - mean) * (count[i] - mean) / mean;
    }
    return chi_square_p(statistic, kBins - 1);
}

TEST(Filter, samples_are_spread_as_the_absolute_value) {
    for (const FilterSettings& filter : examples())
        for (const bool vertical : {false, true})
            EXPECT_GT(spread_p(filter, vertical), 1e-3)
                << static_cast<int>(filter.kind) << filter.radius << vertical;
}

/// Every weight is the same but for its sign, save in cells where f passes zero (0.5% of u).
TEST(Filter, weights_are_plus_or_minus_one_constant) {
    for (const FilterSettings& filter : examples()) {
        const FilterSampler sampler(filter);
        const auto size = [&](const Vec2d& u) { return std::abs(sampler.sample(u).weight); };
        const float usual = size({0.5003, 0.5003});
        const bool lobes = filter.kind == FilterKind::mitchell || filter.kind == FilterKind::sinc;
        EXPECT_TRUE(lobes ? usual > 1 : std::abs(usual - 1) < 1e-3F) << usual;
        int unusual = 0;
        for (int i = 0; i < 10000; ++i)
            if (std::abs(size({(i + 0.5) / 10000, 0.5003}) / usual - 1) > 1e-3F) ++unusual;
        EXPECT_LE(unusual, 50) << static_cast<int>(filter.kind) << filter.radius;
    }
}

TEST(Filter, negative_lobes_get_negative_weights) {
    for (const FilterSettings& filter : examples()) {
        const FilterSampler sampler(filter);
        RandomStream random(4, Purpose::test, 0, 0);
        int negative = 0;
        for (int i = 0; i < 10000; ++i) {
            const double x = random.next();
            const FilterSample s = sampler.sample({x, random.next()});
            ASSERT_EQ(s.weight < 0, filter_value(filter, s.offset) < 0);
            if (s.weight < 0) ++negative;
        }
        const bool lobes = filter.kind == FilterKind::mitchell || filter.kind == FilterKind::sinc;
        EXPECT_EQ(negative > 100, lobes) << static_cast<int>(filter.kind);
    }
}

TEST(Filter, values_are_the_known_ones) {
    EXPECT_EQ(filter_value(settings(FilterKind::box, {1, 1}), {0.9, -1}), 1);
    EXPECT_EQ(filter_value(settings(FilterKind::box, {1, 1}), {1.1, 0}), 0);
    EXPECT_NEAR(filter_value(settings(FilterKind::triangle, {2, 2}), {0.5, -1.5}), 0.75, 1e-15);
    const double edge = std::exp(-4.5);
    EXPECT_NEAR(filter_value(settings(FilterKind::gaussian, {1.5, 1.5}), {0.5, 0}),
                (std::exp(-0.5) - edge) * (1 - edge), 1e-7);
    EXPECT_EQ(filter_value(settings(FilterKind::gaussian, {1.5, 1.5}), {1.5, 0}), 0);
    // Mitchell with B = C = 1/3: 8/9 at the middle, 1/18 at one, -5/144 at one and a half.
    const FilterSettings mitchell = settings(FilterKind::mitchell, {2, 2});
    EXPECT_NEAR(filter_value(mitchell, {0, 0}), 64.0 / 81, 1e-15);
    EXPECT_NEAR(filter_value(mitchell, {1, 0}), 8.0 / 9 / 18, 1e-15);
    EXPECT_NEAR(filter_value(mitchell, {0, -1.5}), 8.0 / 9 * -5 / 144, 1e-15);
    const FilterSettings sinc = settings(FilterKind::sinc, {4, 4});
    EXPECT_NEAR(filter_value(sinc, {0.5, 0}), 2 / kPiDouble * 3 / kPiDouble, 1e-15);
    EXPECT_EQ(filter_value(sinc, {2, 0.3}), 0);
}

}  // namespace
}  // namespace sunfleck::engine
