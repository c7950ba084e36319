// Four kinds of strategies: a ray meets a light, a light is sampled, vertices are joined, the
// camera looks at the light's subpath.
#include "reference/path_pair.h"

namespace sunfleck::engine {

SampledSpectrum PathPair::trace(const Vec2d& film, Numbers& numbers) {
    splats_.clear();
    const std::size_t wavelength = hero_of(numbers.eye.next());
    const std::uint64_t before = tracer_.rays();
    tracer_.trace_eye(film, wavelength, numbers.eye, eye_);
    const std::uint64_t between = tracer_.rays();
    tracer_.trace_light(wavelength, numbers.light, light_);
    camera_rays_ += between - before;
    light_rays_ += tracer_.rays() - between;

    const auto most = static_cast<std::size_t>(pass_.transport.max_depth);
    SampledSpectrum sum = met_lights();
    for (std::size_t i = 0; i < eye_.vertices.size(); ++i) {
        const SubpathVertex& vertex = eye_.vertices[i];
        if (!vertex.is_wide()) continue;
        sum += sampled_light(vertex, numbers.joints);
        const std::size_t events = most - (i + 1);
        for (std::size_t j = 0; j < std::min(events, light_.vertices.size()); ++j)
            if (light_.vertices[j].is_wide()) sum += joined(vertex, light_.vertices[j]);
    }
    for (const SubpathVertex& vertex : light_.vertices)
        if (vertex.is_wide()) splat(vertex, numbers.joints);
    return sum;
}

SampledSpectrum PathPair::met_lights() const {
    SampledSpectrum sum;
    for (const MetLight& met : eye_.lights) {
        if (met.vertices == 0) continue;
        const SubpathVertex& last = eye_.vertices[met.vertices - 1];
        const EndDensities end = end_densities(pass_.scene.scene, met.light, met.ray, last.hit);
        sum += met.seen * static_cast<float>(end_weights(end, last.weighing, last.leaving).met);
    }
    return sum;
}

SampledSpectrum PathPair::unscattered() const {
    SampledSpectrum sum;
    for (const MetLight& met : eye_.lights)
        if (met.vertices == 0) sum += met.seen;
    return sum;
}

/// What media leave of light that goes straight; nothing if it cannot.
SampledSpectrum PathPair::seen(const SubpathVertex& from, const Vec3& way, float distance) {
    ++camera_rays_;
    const MediumNumber medium = pass_.scene.scene.medium_beyond(from.hit, way, from.medium);
    return pass_.scene.seen_from(from.hit, way, distance, medium);
}

SampledSpectrum PathPair::sampled_light(const SubpathVertex& vertex, PathNumbers& numbers) {
    const Scene& scene = pass_.scene.scene;
    const double which = numbers.next();
    const Vec2 place(numbers.next_two());
    const Vec3& from = vertex.hit.position;
    const auto choice = scene.light_tree().choose({from, Vec3(0)}, which);
    if (!choice) return {};
    const auto light = sample_direct(scene.lights()[choice->index], from, place, scene.sphere());
    if (!light) return {};
    const Scattered turned = scattered(vertex, light->direction, Transport::radiance);
    if (turned.weight.is_zero()) return {};
    const SampledSpectrum left = seen(vertex, light->direction, light->distance);
    if (left.is_zero()) return {};
    const Vec3d way(light->direction);
    const double distance = light->distance < kInfinity ? static_cast<double>(light->distance) : 0;
    const LightRay ray{Vec3d(from) + way * distance, light->normal, -way};
    const auto number = static_cast<std::uint32_t>(choice->index);
    const EndDensities end = end_densities(scene, number, ray, vertex.hit);
    const double weight = end_weights(end, vertex.weighing, turned.leaving).sampled;
    const SampledSpectrum emitted = pass_.scene.tinted(pass_.scene.emission[number], light->tint);
    return vertex.arriving * turned.weight * left * emitted *
           static_cast<float>(static_cast<double>(light->factor) * weight / choice->probability);
}

SampledSpectrum PathPair::joined(const SubpathVertex& eye, const SubpathVertex& light) {
    const Vec3d between = Vec3d(light.hit.position) - Vec3d(eye.hit.position);
    const double distance2 = between.length2();
    if (!(distance2 > 0)) return {};
    const double distance = std::sqrt(distance2);
    const Vec3 way(between / distance);
    const Scattered at_eye = scattered(eye, way, Transport::radiance);
    if (at_eye.weight.is_zero()) return {};
    const Scattered at_light = scattered(light, -way, Transport::flux);
    if (at_light.weight.is_zero()) return {};
    const SampledSpectrum left = seen(eye, way, static_cast<float>(distance));
    if (left.is_zero()) return {};
    const double weight = connection_weight(
        {eye.weighing, at_eye.leaving,
         at_light.leaving.forward * static_cast<double>(at_eye.cosine) / distance2},
        {light.weighing, at_light.leaving,
         at_eye.leaving.forward * static_cast<double>(at_light.cosine) / distance2});
    // Both subpaths' shares of one chosen wavelength count all wavelengths for it.
    const double count = eye.hero.single && light.hero.single ? kWavelengths : 1;
    return eye.arriving * at_eye.weight * left * at_light.weight * light.arriving *
           static_cast<float>(weight / (distance2 * count));
}

void PathPair::splat(const SubpathVertex& vertex, PathNumbers& numbers) {
    const auto sight = camera_.sight_of(Vec3d(vertex.hit.position), numbers.next_two());
    if (!sight || !splatter_.reaches(sight->film)) return;
    const Vec3 between = Vec3(sight->origin) - vertex.hit.position;
    const float distance = between.length();
    if (!(distance > 0)) return;
    const Vec3 way = between / distance;
    const Scattered turned = scattered(vertex, way, Transport::flux);
    if (turned.weight.is_zero()) return;
    const SampledSpectrum left = seen(vertex, way, distance);
    if (left.is_zero()) return;
    const double weight =
        light_image_weight(vertex.weighing, turned.leaving,
                           sight->area * static_cast<double>(turned.cosine), light_paths_);
    splats_.push_back({sight->film, vertex.arriving * turned.weight * left *
                                        static_cast<float>(sight->area * weight)});
}

}  // namespace sunfleck::engine
