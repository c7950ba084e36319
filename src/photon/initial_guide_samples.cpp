// Light samples, their visibility, and the inverse of their emission.
#include "photon/initial_guide_samples.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

std::optional<LightAtPoint> InitialGuideSamples::sample(const Vec3& at,
                                                        RandomStream& stream) const {
    const auto choice = lights_.choose(stream.next());
    const float first = stream.next_float();
    const Vec2 u(first, stream.next_float());
    const auto direct =
        sample_direct(scene_.scene.lights()[choice.index], at, u, scene_.scene.sphere());
    if (!direct) return {};
    return LightAtPoint{choice.index, choice.probability, *direct};
}

int InitialGuideSamples::panes_to(Ray ray, float distance) const {
    float left = distance * (1 - 1e-4F);
    for (int panes = 0; panes < kMostPanes; ++panes) {
        ray.length = left;
        auto hit = scene_.scene.geometry().intersect(ray);
        if (!hit) return panes;
        if (!scene_.scene.is_null_interface(*hit) && !is_clear(*hit, ray.direction)) return -1;
        left -= hit->distance;
        if (!(left > 0)) return panes + 1;
        ray = ray_from(*hit, ray.direction);
    }
    return -1;
}

/// Returns whether a specular surface transmits light.
bool InitialGuideSamples::is_clear(Hit& hit, const Vec3& direction) const {
    std::optional<Bsdf> room;
    const Bsdf& bsdf = scene_.bsdf_at(hit, room);
    if (scattering(bsdf) != Scattering::specular) return false;
    const Vec3 wo = Frame(hit.shading_normal, hit.tangent).to_local(-direction);
    constexpr float kLast = 1 - 0x1p-20F;  // the last lobe: transmission
    const auto through =
        sunfleck::engine::sample(bsdf, wo, {{kLast, 0.5F, 0.5F}, Transport::radiance, {}});
    return through && through->wi.z * wo.z < 0;
}

SampledSpectrum InitialGuideSamples::emitted_by(std::size_t light) const {
    const SampledSpectrum& emission = scene_.emission[light];
    if (!emission.is_zero()) return emission;
    const Scene& scene = scene_.scene;
    const LightChoice& all = scene.light_choice();
    const double weight = all.total() * all.probability(light);
    return SampledSpectrum(
        static_cast<float>(weight / power(scene.lights()[light], scene.sphere())));
}

std::optional<WeightedEmission> InitialGuideSamples::guide_sample(const LightAtPoint& sample,
                                                                  const Vec3& at, double weight,
                                                                  RandomStream& stream) const {
    const Light& light = scene_.scene.lights()[sample.light];
    const DirectSample& direct = sample.direct;
    const Vec3d to_light(direct.direction);
    Vec3d origin(at);
    if (!comes_from_afar(light)) origin += to_light * static_cast<double>(direct.distance);
    const EmissionDimensions u =
        emission_dimensions(light, {origin, direct.normal, -to_light}, scene_.scene.sphere());
    EmissionPoint point;
    std::transform(u.begin(), u.end(), point.begin(),
                   [&](double x) { return std::isnan(x) ? stream.next() : x; });
    point[dimension(EmissionDimension::light)] = lights_.number(sample.light, stream.next());
    const auto is_number = [](double x) { return x > 0 && x < 1; };
    if (!(weight > 0) || !std::all_of(point.begin(), point.end(), is_number)) return {};
    return WeightedEmission{point, weight};
}

}  // namespace sunfleck::engine
