// Laws that every light keeps, over all examples: power, the two halves of MIS, and photons that
// bring what direct samples promise.
//
// Fixed seeds. Each statistical test has significance 1e-4; the smallest effects seen are stated
// with the tests.
#include "core/random.h"
#include "laws/light_examples.h"
#include "laws/light_surfaces.h"
#include "laws/significance.h"
#include "light/light.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace sunfleck::engine {
namespace {

using namespace testing_support;

class LightLaws : public testing::TestWithParam<LightExample> {
protected:
    const Light& light() const { return light_; }
    const AreaLight* area_light() const { return std::get_if<AreaLight>(&light()); }
    bool is_seen_area_light() const { return area_light() != nullptr && !area_light()->unseen; }
    Vec2 random_2d() { return {random_.next_float(), random_.next_float()}; }
    double irradiance_at(const Vec3d& point, const Vec3d& normal);

    const Light light_ = GetParam().make();
    RandomStream random_{6, Purpose::test, 0, 0};
};

TEST(LightExamples, cover_every_kind_and_surface) {
    std::set<std::size_t> kinds;
    std::set<std::string_view> names;
    std::set<std::size_t> surfaces;
    std::size_t infinite = 0;
    for (const LightExample& example : light_examples()) {
        const Light light = example.make();
        kinds.insert(light.index());
        names.insert(name_of(light));
        infinite += is_infinite(light) ? 1 : 0;
        if (const auto* area = std::get_if<AreaLight>(&light))
            surfaces.insert(area->surface.index());
    }
    EXPECT_EQ(kinds.size(), std::variant_size_v<Light>);
    EXPECT_EQ(names.size(), kinds.size());
    EXPECT_EQ(infinite, infinite_examples().size());  // EnvironmentLaws has them all
    EXPECT_EQ(surfaces.size(), std::variant_size_v<decltype(AreaLight::surface)>);
}

/// By midpoints of 512^2 positions, or directions: right to 1e-4. (No light's depends on both.)
/// A picture's power on a surface, or behind a portal, is by quadrature: right to 2e-3.
TEST_P(LightLaws, emitted_factors_add_up_to_the_power) {
    constexpr int kSide = 512;
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec2d on((x + 0.5) / kSide, (y + 0.5) / kSide);
            const EmissionDimensions u = {on.x, on.y, on.y, on.x};
            sum += sample_emission(light(), u, kExampleSphere).factor;
        }
    const double expected = power(light(), kExampleSphere);
    const bool pictured = area_light() != nullptr
                              ? area_light()->image != nullptr
                              : std::holds_alternative<PortalLight>(light()) ||
                                    std::holds_alternative<MediumLight>(light());
    EXPECT_NEAR(sum / (kSide * kSide), expected, (pictured ? 2e-3 : 1e-4) * expected);
}

TEST_P(LightLaws, emission_leaves_the_emitting_side) {
    for (int i = 0; i < 10000; ++i) {
        const EmissionDimensions u = {random_.next(), random_.next(), random_.next(),
                                      random_.next(), random_.next()};
        const Emission e = sample_emission(light(), u, kExampleSphere);
        ASSERT_NEAR(e.direction.length(), 1, 1e-14);
        ASSERT_EQ(area_light() != nullptr, e.normal.length() > 0.5F);
        if (area_light() == nullptr) continue;
        ASSERT_NEAR(e.normal.length(), 1, 1e-6F);
        ASSERT_TRUE(area_light()->emits(e.normal, Vec3(e.direction)));
        // The origin lies on the surface: a ray that meets it from the front finds it again.
        const Vec3d n(e.normal);
        const auto all = [&](const auto& s) { return surface_hits(s, e.origin + n * 1e-4, -n); };
        double nearest = 1;
        for (const SurfaceHit& hit : std::visit(all, area_light()->surface))
            if ((hit.position - e.origin).length() < nearest) {
                nearest = (hit.position - e.origin).length();
                ASSERT_NEAR((hit.normal - n).length(), 0, 1e-3) << e.origin;
            }
        ASSERT_LT(nearest, 1e-6) << e.origin;
        ASSERT_GT(e.error, 0);
        ASSERT_LT(e.error, 1e-5F);
    }
}

TEST_P(LightLaws, only_lights_of_some_width_give_a_pdf) {
    for (int i = 0; i < 10000; ++i) {
        const auto s = sample_direct(light(), GetParam().point, random_2d(), kExampleSphere);
        if (!s) continue;
        ASSERT_NEAR(s->direction.length(), 1, 1e-6F);
        ASSERT_EQ(s->pdf.has_value(), is_seen_area_light() || is_infinite(light()));
        if (!is_seen_area_light()) continue;
        ASSERT_NEAR(s->normal.length(), 1, 1e-5F);
        ASSERT_EQ(s->rgb.has_value(), area_light()->image != nullptr);
        if (area_light()->image) continue;
        ASSERT_NEAR(s->factor * *s->pdf, 1, 1e-5F);
    }
}

/// The point of the light that a direct sample stands for: the one at its distance.
std::optional<SurfaceHit> sampled_point(const AreaLight& light, const Vec3d& point,
                                        const DirectSample& sample) {
    for (const SurfaceHit& hit : emitting_hits(light, point, Vec3d(sample.direction))) {
        const double distance = (hit.position - point).length();
        if (std::abs(distance - static_cast<double>(sample.distance)) < 1e-4) return hit;
    }
    return {};
}

/// Sees a pdf that is off by 2e-4, at cosines at the light above 0.05.
TEST_P(LightLaws, direct_pdf_is_that_of_the_sample) {
    if (!is_seen_area_light()) return;
    const Vec3 point = GetParam().point;
    int lost = 0;
    int tested = 0;
    for (int i = 0; i < 10000; ++i) {
        const auto s = sample_direct(light(), point, random_2d(), kExampleSphere);
        if (!s) continue;
        const auto on = sampled_point(*area_light(), Vec3d(point), *s);
        if (!on) ++lost;  // past the edge by rounding
        if (!on || std::abs(on->normal.dot(Vec3d(s->direction))) < 0.05) continue;
        ++tested;
        const float pdf = area_light()->direct_pdf(point, Vec3(on->position), Vec3(on->normal));
        ASSERT_NEAR(pdf / *s->pdf, 1, 2e-4F) << s->direction;
        ASSERT_NEAR((Vec3(on->normal) - s->normal).length(), 0, 1e-3F) << s->direction;
    }
    EXPECT_GT(tested, 2000);
    EXPECT_LE(lost, 10);
}

/// Bins of equal solid angle around the x axis: the examples shine from above, where these are
/// nearly square.
struct DirectionBins {
    static constexpr int kRows = 16;
    static constexpr int kColumns = 32;
    static constexpr std::size_t kCount = std::size_t{kRows} * kColumns;

    static std::size_t index(const Vec3d& w) {
        const double turn = std::atan2(w.z, w.y) / (2 * kPiDouble);
        const int row = std::clamp(static_cast<int>((w.x + 1) / 2 * kRows), 0, kRows - 1);
        const int column =
            std::clamp(static_cast<int>((turn - std::floor(turn)) * kColumns), 0, kColumns - 1);
        return static_cast<std::size_t>(row * kColumns + column);
    }
};

/// The solid angle in which the light shines towards the point, counted once for each of its
/// points in line, in each bin: by 48^2 midpoints a bin.
std::vector<double> shining_solid_angles(const AreaLight& light, const Vec3d& point) {
    constexpr int kRows = DirectionBins::kRows * 48;
    constexpr int kColumns = DirectionBins::kColumns * 48;
    std::vector<double> sums(DirectionBins::kCount, 0);
    for (int column = 0; column < kColumns; ++column) {
        const SinCos phi = sin_cos_2pi((column + 0.5) / kColumns);
        for (int row = 0; row < kRows; ++row) {
            const double x = 2 * (row + 0.5) / kRows - 1;
            const double r = std::sqrt(1 - x * x);
            const Vec3d w(x, r * phi.cos, r * phi.sin);
            const auto hits = static_cast<double>(emitting_hits(light, point, w).size());
            sums[DirectionBins::index(w)] += hits * 4 * kPiDouble / (kRows * kColumns);
        }
    }
    return sums;
}

/// 1/pdf summed over samples in a bin of directions is the solid angle of what shines there: so
/// the pdf is the true density of the samples, and no part of the light is forgotten. Sees 2%
/// over a quarter of the light. (With a picture there are no samples of what is black in it, and
/// the others are those without.)
TEST_P(LightLaws, inverse_pdf_measures_the_solid_angle) {
    if (!is_seen_area_light() || area_light()->image) return;
    constexpr int kSamples = 1 << 18;
    const auto truth = shining_solid_angles(*area_light(), Vec3d(GetParam().point));
    std::vector<Vec3d> sums(truth.size(), Vec3d(0));  // count, sum and sum of squares of 1/pdf
    for (int i = 0; i < kSamples; ++i) {
        const auto s = sample_direct(light(), GetParam().point, random_2d(), kExampleSphere);
        if (!s) continue;
        const auto factor = static_cast<double>(s->factor);
        sums[DirectionBins::index(Vec3d(s->direction))] += Vec3d(1, factor, factor * factor);
    }
    double statistic = 0;
    int bins = 0;
    const auto compare = [&](const Vec3d& sum, double expected) {
        const double mean = sum.y / kSamples;
        const double variance = (sum.z / kSamples - mean * mean) / kSamples;
        statistic += (mean - expected) * (mean - expected) / variance;
        ++bins;
    };
    Vec3d rare(0);
    double rare_truth = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (sums[i].x >= 200) compare(sums[i], truth[i]);
        if (sums[i].x >= 200) continue;
        rare += sums[i];
        rare_truth += truth[i];
    }
    if (rare_truth > 0) compare(rare, rare_truth);
    EXPECT_GT(bins, 8);
    EXPECT_GT(chi_square_p(statistic, bins), kSignificance) << statistic << " of " << bins;
}

/// Returns an estimate of the irradiance: by a direct sample, or by a point of a medium.
double LightLaws::irradiance_at(const Vec3d& point, const Vec3d& normal) {
    const auto above = [&](const Vec3d& way) { return std::max(0.0, way.dot(normal)); };
    if (const auto* medium = std::get_if<MediumLight>(&light())) {
        const Affine& map = medium->density->to_world();
        const Voxel& cells = medium->density->voxels().cells();
        const Vec3d in_lattice(random_.next() * cells[0], random_.next() * cells[1],
                               random_.next() * cells[2]);
        const Vec3d at = map.point(in_lattice);
        const double volume = std::abs(map.determinant()) * cells[0] * cells[1] * cells[2];
        const double distance2 = (at - point).length2();
        return above((at - point).normalized()) / distance2 * volume *
               static_cast<double>(medium->density->at(Vec3(at)));
    }
    const auto s = sample_direct(light(), Vec3(point), random_2d(), kExampleSphere);
    return s ? above(Vec3d(s->direction)) * static_cast<double>(s->factor) : 0;
}

/// Flux through a disc: photons that cross it against direct samples on it. Sees 5% (with 32
/// times the samples, all agreed within 0.3%).
TEST_P(LightLaws, photons_bring_what_direct_samples_promise) {
    constexpr int kSamples = 1 << 20;
    constexpr double kRadius = 0.5;
    const Vec3d point(GetParam().point);
    const Vec3d normal(GetParam().normal);
    std::array<Vec2d, 2> sums = {Vec2d(0), Vec2d(0)};  // photons, direct: sum, sum of squares
    const auto add = [](Vec2d& sum, double x) { sum += Vec2d(x, x * x); };
    for (int i = 0; i < kSamples; ++i) {
        const EmissionDimensions u = {random_.next(), random_.next(), random_.next(),
                                      random_.next(), random_.next()};
        const Emission e = sample_emission(light(), u, kExampleSphere);
        const double t = (point - e.origin).dot(normal) / e.direction.dot(normal);
        const bool front = e.direction.dot(normal) < 0;
        const Vec3d crossed = e.origin + e.direction * t;
        const bool meets = front && t > 0 && t < e.lit_to && (crossed - point).length() < kRadius;
        add(sums[0], meets ? e.factor : 0);
        if (i % 4 != 0) continue;
        const Vec2d disc = concentric_disc({random_.next(), random_.next()}) * kRadius;
        const Vec3d on = point + rotate_z_to(normal, {disc.x, disc.y, 0});
        add(sums[1], irradiance_at(on, normal) * kPiDouble * kRadius * kRadius);
    }
    std::array<double, 2> mean{};
    double variance = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double count = i == 0 ? kSamples : kSamples / 4;
        mean.at(i) = sums.at(i).x / count;
        variance += (sums.at(i).y / count - mean.at(i) * mean.at(i)) / count;
    }
    EXPECT_LT(std::sqrt(variance), 0.012 * mean[1]) << "the test would see too little";
    EXPECT_GT(normal_p((mean[0] - mean[1]) / std::sqrt(variance)), kSignificance)
        << mean[0] << " against " << mean[1] << " +- " << std::sqrt(variance);
}

INSTANTIATE_TEST_SUITE_P(Examples, LightLaws, testing::ValuesIn(light_examples()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine
