// Light samples and their candidates.
#include "camera_paths/next_event_estimation.h"

#include "support/direct_light_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// What a candidate's weight was, and what a bsdf sample into the same direction would weigh.
void expect_weights_sum_to_one(const LitPoint& point, const RisCandidate& candidate) {
    const PassScene& pass = point.pass();
    const CameraVertex& vertex = point.vertex();
    if (candidate.arriving.is_zero()) return;
    const Receiver from = receiver_at(pass.scene, vertex);
    const Ray ray = ray_from(vertex.hit, candidate.direction);
    const auto hit = pass.scene.geometry().intersect(ray);
    const EmitterMet met = hit ? emitter_at(pass, *hit, &from, candidate.direction)
                               : emitter_beyond(pass, vertex.hit.position, candidate.direction);
    if (met.radiance.is_zero() || (hit && pass.scene.light_of(*hit) != candidate.light)) return;
    const auto density =
        static_cast<float>(pass.scene.light_tree().probability(from, candidate.light)) *
        (hit ? 1 : 1 / (4 * kPi));
    const Vec3 wi = vertex.frame.to_local(candidate.direction);
    const SampledSpectrum f = eval(vertex.bsdf, vertex.wo, wi, Transport::radiance);
    const float of_all = static_cast<float>(ris_candidates(vertex)) * (hit ? met.pdf : density);
    const float light_weight = candidate.arriving[0] * of_all /
                               (f[0] * std::abs(wi.z) * pass.emission[candidate.light][0]);
    Statistics statistics;
    const BsdfSample drawn{SampledSpectrum(1), wi,
                           pdf(vertex.bsdf, vertex.wo, wi, Transport::radiance)};
    const float bsdf_weight =
        follow_bsdf_sample(pass, vertex, drawn, statistics)[0] / met.radiance[0];
    EXPECT_NEAR(light_weight + bsdf_weight, 1, 2e-4) << light_weight << ' ' << bsdf_weight;
    EXPECT_GT(light_weight, 0);
    EXPECT_LT(light_weight, 1);
}

TEST(LightSample, weights_of_light_and_bsdf_samples_sum_to_one) {
    Matrix place;
    place.translate(Vec3d(-1, 2, 2));
    for (const std::uint32_t material : {0U, 1U}) {
        SceneDescription scene = floor_of(material);
        scene.shapes.push_back(lamp(quad(kCeiling), 2));
        scene.shapes.push_back(lamp({{Sphere{0.5, -0.5, 0.5}, place, false}, 0, {}, {}}, 5));
        place.translate(Vec3d(3, 0, 0));
        scene.shapes.push_back(lamp({{Disk{0, 0.7}, place, true}, 0, {}, {}}, 3, true));
        for (const float radiance : {0.1F, 0.3F})
            scene.lights.emplace_back(InfiniteLight{Spectrum::constant(radiance)});
        LitPoint point(std::move(scene));
        RandomStream random(3, Purpose::test, 0, material);
        for (int i = 0; i < 300; ++i) {
            if (i == 200) point.leave_candidates_out();
            const LightNumbers u{random.next(), {random.next(), random.next()}, 0};
            for (const RisCandidate& light : candidates_at(point.pass(), point.vertex(), u))
                expect_weights_sum_to_one(point, light);
            if (HasFailure()) return;
        }
    }
}

/// Two lamps and half a plate before the larger: at a diffuse surface each candidate has a ray; at
/// a glossy one the one that is picked, and the mean over all picks is the sum of what is seen.
TEST(LightSample, a_sample_has_the_light_of_all_candidates) {
    for (const std::uint32_t material : {0U, 1U}) {
        SceneDescription scene = floor_of(material);
        scene.shapes.push_back(lamp(quad(kCeiling), 2));
        scene.shapes.push_back(lamp(quad(kWall), 1));
        scene.shapes.push_back(
            quad({{{.3F, -9, 1.5F}, {1, -9, 1.5F}, {1, 9, 1.5F}, {.3F, 9, 1.5F}}}));
        const LitPoint point(std::move(scene));
        RandomStream random(4, Purpose::test, 0, material);
        int hidden = 0;
        for (int i = 0; i < 50; ++i) {
            LightNumbers u{random.next(), {random.next(), random.next()}, 0};
            double seen = 0;
            unsigned many = 0;
            for (const RisCandidate& light : candidates_at(point.pass(), point.vertex(), u)) {
                const SampledSpectrum left =
                    point.pass().seen_from(point.vertex().hit, light.direction, light.distance, 0);
                seen += static_cast<double>((light.arriving * left)[0]);
                many += light.arriving.is_zero() ? 0 : 1;
                hidden += !light.arriving.is_zero() && left.is_zero() ? 1 : 0;
            }
            const bool each = material == 0;
            const unsigned picks = each ? 1 : 2000;
            double mean = 0;
            Statistics statistics;
            for (unsigned pick = 0; pick < picks; ++pick) {
                u.pick = (pick + 0.5) / picks;
                mean += static_cast<double>(point.by_light(u, statistics)[0]) / picks;
            }
            EXPECT_NEAR(mean, seen, (each ? 1e-6 : 0.01) * std::max(seen, 0.01)) << i;
            EXPECT_EQ(statistics[Count::camera_rays], picks * (each ? many : many > 0 ? 1 : 0));
        }
        EXPECT_GT(hidden, 20) << material;
    }
}

TEST(LightSample, one_candidate_brings_the_light_of_all) {
    for (const std::uint32_t material : {0U, 1U}) {
        SceneDescription scene = floor_of(material);
        scene.shapes.push_back(lamp(quad(kCeiling), 2));
        LitPoint point(std::move(scene));
        const Interval several = reflected(point);
        point.leave_candidates_out();
        EXPECT_EQ(ris_candidates(point.vertex()), 1U);
        const Interval one = reflected(point);
        EXPECT_NEAR(one.mean, several.mean, 0.004 * several.mean);
        EXPECT_LT(one.half + several.half, 0.003 * several.mean);
    }
}

/// All candidates together are a net over choice and place: their sum has less noise than if each
/// were by itself, whose variance is that of one times their number.
TEST(LightSample, candidates_fill_the_lights_evenly) {
    for (const std::uint32_t material : {0U, 1U}) {
        SceneDescription scene = floor_of(material);
        scene.lights = {InfiniteLight{Spectrum::constant(1)}};
        const LitPoint point(std::move(scene));
        const std::size_t count = ris_candidates(point.vertex());
        RandomStream random(6, Purpose::test, 0, material);
        const auto many = static_cast<double>(count);
        constexpr std::size_t kSamples = 20'000;
        std::array<double, 2> sums{};  // of one candidate, of all
        std::array<double, 2> squares{};
        for (std::size_t i = 0; i < kSamples; ++i) {
            const LightNumbers u{random.next(), {random.next(), random.next()}, 0};
            std::array<double, 2> light{};
            const RisCandidates candidates = candidates_at(point.pass(), point.vertex(), u);
            for (const RisCandidate& candidate : candidates)
                light[1] += static_cast<double>(candidate.arriving[0]);
            light[0] = static_cast<double>(candidates.at(i % count).arriving[0]);
            for (const std::size_t k : {0U, 1U}) {
                sums.at(k) += light.at(k) / kSamples;
                squares.at(k) += light.at(k) * light.at(k) / kSamples;
            }
        }
        EXPECT_NEAR(sums[0] * many / sums[1], 1, 0.05);
        const double one = squares[0] - sums[0] * sums[0];
        EXPECT_LT(squares[1] - sums[1] * sums[1], 0.5 * many * one) << material;
    }
}

TEST(MisWeight, power_heuristic_of_two) {
    EXPECT_FLOAT_EQ(mis_weight(1, 1), 0.5F);
    EXPECT_FLOAT_EQ(mis_weight(3, 1), 0.9F);
    EXPECT_FLOAT_EQ(mis_weight(1, 3), 0.1F);
    EXPECT_EQ(mis_weight(2, 0), 1);
    EXPECT_EQ(mis_weight(0, 2), 0);
}

/// Densities run over all of float: a lamp far away is small. Squares of them do not fit.
TEST(MisWeight, densities_of_any_size) {
    EXPECT_EQ(mis_weight(1e30F, 1), 1);
    EXPECT_EQ(mis_weight(1, 1e30F), 0);
    EXPECT_FLOAT_EQ(mis_weight(3e30F, 1e30F), 0.9F);
    EXPECT_FLOAT_EQ(mis_weight(3e-30F, 1e-30F), 0.9F);
    EXPECT_EQ(mis_weight(1e38F, 1e-38F), 1);
    EXPECT_EQ(mis_weight(1e-38F, 1e38F), 0);
}

}  // namespace
}  // namespace sunfleck::engine
