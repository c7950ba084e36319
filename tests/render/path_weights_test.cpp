// Weights of all strategies that make one path: they sum to one, and each is the density of its
// strategy over the sum of all, by products along the whole path.
#include "reference/subpath.h"
#include "support/reference_scenes.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kLightPaths = 37;

double geometric_cosine(const Hit& hit, const Vec3& way) {
    return std::abs(static_cast<double>(hit.normal.dot(way)));
}

/// A path that a camera subpath found: vertices 0 (next to the camera) to n - 1 (next to the
/// light).
class FoundPath {
public:
    FoundPath(const PassScene& scene, const Projection& projection, const Subpath& camera,
              const MetLight& met)
        : eye_(camera.vertices.begin(), camera.vertices.begin() + long(met.vertices)) {
        end_ = end_densities(scene.scene, met.light, met.ray, eye_.back().hit);
        light_ = eye_;
        for (std::size_t i = 0; i < light_.size(); ++i) {
            const std::size_t at = light_.size() - 1 - i;  // from the light
            SubpathVertex& vertex = light_[at];
            // The other way round, of the same numbers.
            vertex.leaving = {eye_[at].leaving.back, eye_[at].leaving.forward,
                              eye_[at].leaving.is_delta};
            vertex.weighing =
                i == 0 ? first_of_light(end_)
                       : next_weights(light_[at + 1].weighing, light_[at + 1].leaving,
                                      geometric_cosine(light_[at + 1].hit, way(at)),
                                      geometric_cosine(vertex.hit, way(at)), distance2(at));
        }
        const Vec3d first(eye_[0].hit.position);
        const auto sight = projection.sight_of(first, Vec2d(0.5));
        seen_ =
            sight->area * geometric_cosine(eye_[0].hit, Vec3((sight->origin - first).normalized()));
    }

    std::size_t vertices() const { return eye_.size(); }
    bool has_mirror() const {
        return std::any_of(eye_.begin(), eye_.end(),
                           [](const auto& v) { return v.leaving.is_delta; });
    }

    /// Of the strategies with 0 .. vertices() + 1 vertices from the light, its end counted: as the
    /// renderer has them.
    std::vector<double> weights() const {
        const EndWeights at_end = end_weights(end_, eye_.back().weighing, eye_.back().leaving);
        std::vector<double> all{at_end.met, at_end.sampled};
        for (std::size_t light = 1; light < vertices(); ++light) {
            const std::size_t at = vertices() - light;  // of the last one from the light
            const bool joins = !eye_[at - 1].leaving.is_delta && !eye_[at].leaving.is_delta;
            all.push_back(
                !joins ? 0
                       : connection_weight(
                             {eye_[at - 1].weighing, eye_[at - 1].leaving, made_by_light(at - 1)},
                             {light_[at].weighing, light_[at].leaving, made_by_eye(at)}));
        }
        all.push_back(
            eye_[0].leaving.is_delta
                ? 0
                : light_image_weight(light_[0].weighing, light_[0].leaving, seen_, kLightPaths));
        return all;
    }

    /// The same by products of densities.
    std::vector<double> expected() const {
        std::vector<double> all;
        double sum = 0;
        for (std::size_t light = 0; light <= vertices() + 1; ++light) {
            double density = light == vertices() + 1 ? kLightPaths : 1;
            const std::size_t by_camera = vertices() + 1 - std::max<std::size_t>(light, 1);
            for (std::size_t i = 0; i < by_camera; ++i) density *= made_by_eye(i);
            if (light == 0) density *= end_.hit * eye_.back().leaving.forward;
            if (light == 1) density *= end_.direct;
            for (std::size_t i = by_camera; i < vertices(); ++i) density *= made_by_light(i);
            // Across this edge it is joined.
            const auto is_mirror = [&](std::size_t i) {
                return i < vertices() && eye_[i].leaving.is_delta;
            };
            if (light > 0 && (is_mirror(by_camera - 1) || is_mirror(by_camera))) density = 0;
            all.push_back(density);
            sum += density;
        }
        for (double& density : all) density /= sum;
        return all;
    }

private:
    /// From vertex `at` to the one nearer to the light.
    Vec3 way(std::size_t at) const {
        return (eye_[at + 1].hit.position - eye_[at].hit.position).normalized();
    }
    double distance2(std::size_t at) const {
        return (Vec3d(eye_[at + 1].hit.position) - Vec3d(eye_[at].hit.position)).length2();
    }
    double made_by_eye(std::size_t at) const {
        if (at == 0) return seen_;
        return eye_[at - 1].leaving.forward * geometric_cosine(eye_[at].hit, way(at - 1)) /
               distance2(at - 1);
    }
    double made_by_light(std::size_t at) const {
        if (at + 1 == vertices()) return end_.emitted;
        return eye_[at + 1].leaving.back * geometric_cosine(eye_[at].hit, way(at)) / distance2(at);
    }

    std::vector<SubpathVertex> eye_;
    std::vector<SubpathVertex> light_;
    EndDensities end_;
    double seen_ = 0;
};

TEST(PathWeights, of_all_strategies_sum_to_one) {
    const Scene scene =
        scene_of(view("0 -3 1  0 0 .8  0 0 1", 45, 16) +
                 "LightSource \"infinite\" \"rgb L\" [.2 .2 .2]\n" + corner() + metal_block() +
                 "Material \"conductor\"\n" + box({-0.8, 0.2, 0}, {-.3, 0.7, 0.9}) +
                 glass_ball("\"coateddiffuse\" \"float roughness\" .3") + lamp_above("1 1 1"));
    const PassScene at_wavelengths(scene, {5, 0});
    const TransportSettings transport{DirectLight::sampled, 7};
    const ReferencePass pass{at_wavelengths, transport, {0, 0, 16, 16}, {5, 0}};
    const Projection projection(scene.camera());
    SubpathTracer tracer(pass, projection, kLightPaths);
    Subpath camera;
    std::array<int, 9> tested{};
    int mirrors = 0;
    RandomStream random(5, Purpose::test, 0, 0);
    for (std::uint32_t i = 0; i < 60'000; ++i) {
        PathNumbers numbers(RandomStream(5, Purpose::test, 1, i));
        tracer.trace_eye({random.next() * 16, random.next() * 16}, 0, numbers, camera);
        for (const MetLight& met : camera.lights) {
            if (met.vertices == 0) continue;
            const FoundPath path(at_wavelengths, projection, camera, met);
            const auto weights = path.weights();
            const auto expected = path.expected();
            double sum = 0;
            for (std::size_t s = 0; s < weights.size(); ++s) {
                ASSERT_NEAR(weights[s], expected[s], 1e-4) << s << " of " << path.vertices();
                sum += weights[s];
            }
            ASSERT_NEAR(sum, 1, 1e-4) << path.vertices();
            ++tested.at(path.vertices());
            mirrors += path.has_mirror() ? 1 : 0;
        }
    }
    for (std::size_t n = 1; n < 7; ++n) EXPECT_GT(tested.at(n), 20) << n;
    EXPECT_GT(mirrors, 100);
}

}  // namespace
}  // namespace sunfleck::engine
