// Random walks from the camera and from lights, with their densities.
#include "reference/subpath.h"

#include "reference/surface.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// Converts to float and keeps the result below one.
float below_one(double u) {
    return std::min(static_cast<float>(u), 1 - 0x1p-24F);
}

Transport other(Transport transport) {
    return transport == Transport::radiance ? Transport::flux : Transport::radiance;
}

double cosine_at(const Hit& hit, const Vec3& way) {
    return std::abs(static_cast<double>(hit.normal.dot(way)));
}

/// Returns the shading-normal correction (Veach 1997, section 5.3).
float adjoint_at(const SubpathVertex& vertex, const Vec3& came) {
    return std::abs(vertex.wo.z / came.dot(vertex.hit.normal));
}

}  // namespace

Scattered scattered(const SubpathVertex& vertex, const Vec3& way, Transport transport) {
    const Vec3 wi = vertex.frame.to_local(way);
    const auto cosine = static_cast<float>(cosine_at(vertex.hit, way));
    const float factor = transport == Transport::flux ? vertex.adjoint * cosine : std::abs(wi.z);
    Scattered result;
    result.weight = eval(vertex.bsdf, vertex.wo, wi, transport) * factor;
    result.cosine = cosine;
    if (result.weight.is_zero()) return result;
    result.leaving = {pdf(vertex.bsdf, vertex.wo, wi, transport),
                      pdf(vertex.bsdf, wi, vertex.wo, other(transport)), false};
    return result;
}

EndDensities end_densities(const Scene& scene, std::uint32_t number, const LightRay& ray,
                           const Hit& at) {
    const Light& light = scene.lights()[number];
    const Vec3 way(ray.direction);
    EndDensities end;
    end.direct = scene.light_tree().probability({at.position, Vec3(0)}, number);
    end.emitted = scene.light_choice().probability(number) *
                  emission_pdf(light, ray, scene.sphere()) * cosine_at(at, way);
    if (const auto* area = std::get_if<AreaLight>(&light)) {
        const double cosine = std::abs(Vec3d(ray.normal).dot(ray.direction));
        end.emitted = cosine > 0 ? end.emitted / cosine : 0;
        end.direct *=
            static_cast<double>(area->direct_pdf(at.position, Vec3(ray.origin), ray.normal));
        end.hit = area->unseen ? 0 : 1;
    } else if (is_infinite(light)) {
        end.direct *= static_cast<double>(environment_radiance(light, at.position, -way).pdf);
        end.hit = 1;
    } else if (!comes_from_afar(light)) {
        end.emitted /= (Vec3d(at.position) - ray.origin).length2();
    }
    // Too large for floats; samples of such a light are refused, too.
    if (!std::isfinite(end.direct)) end.direct = 0;
    if (!std::isfinite(end.emitted)) end.emitted = 0;
    return end;
}

void SubpathTracer::trace_camera(const Vec2d& film, std::size_t wavelength, PathNumbers& numbers,
                                 Subpath& path) {
    path.clear();
    transport_ = Transport::radiance;
    lens_ = numbers.next_two();
    const CameraRay ray = camera_ray(pass_.scene.scene.camera(), film, lens_);
    start_ = {ray.origin, Vec3(0), ray.direction};
    throughput_ = SampledSpectrum(1);
    hero_ = {wavelength, false};
    medium_ = pass_.scene.scene.media().at_camera;
    direction_ = Vec3(ray.direction);
    from_ = Vec3(ray.origin);
    ray_hit_ = pass_.scene.scene.geometry().trace_precise(ray.origin, ray.direction);
    unlit_ = 0;
    lit_to_ = kInfinity;
    scale_ = 1;
    follow(numbers, path);
}

void SubpathTracer::trace_light(std::size_t wavelength, PathNumbers& numbers, Subpath& path) {
    path.clear();
    transport_ = Transport::flux;
    const Scene& scene = pass_.scene.scene;
    if (scene.light_choice().empty()) return;
    const auto choice = scene.light_choice().choose(numbers.next());
    const Vec2d place = numbers.next_two();
    const Vec2d way = numbers.next_two();
    light_ = static_cast<std::uint32_t>(choice.index);
    const Emission start =
        sample_emission(scene.lights()[light_], {place.x, place.y, way.x, way.y}, scene.sphere());
    if (!(start.factor > 0)) return;
    start_ = {start.origin, start.normal, start.direction};
    throughput_ = pass_.scene.coloured(pass_.scene.emission[light_], start.rgb) *
                  static_cast<float>(start.factor / choice.probability);
    hero_ = {wavelength, false};
    medium_ = pass_.scene.start_medium(light_, start, throughput_);
    direction_ = Vec3(start.direction);
    const Vec3d normal(start.normal);
    const Vec3d origin =
        start.origin + normal * (normal.dot(start.direction) < 0 ? -start.error : start.error);
    from_ = Vec3(origin);
    ray_hit_ = scene.geometry().trace_precise(origin, start.direction);
    unlit_ = static_cast<float>(start.unlit);
    lit_to_ = static_cast<float>(start.lit_to);
    follow(numbers, path);
}

void SubpathTracer::follow(PathNumbers& numbers, Subpath& path) {
    const auto most = static_cast<std::size_t>(pass_.transport.max_depth);
    const bool looks_for_lights = transport_ == Transport::radiance;
    while (next_surface(path) && path.vertices.size() < most) {
        path.vertices.push_back(vertex_at_hit(path));
        if (!looks_for_lights && path.vertices.size() == most) return;
        if (!scatter(numbers, path.vertices.back(), path.vertices.size() - 1)) return;
    }
}

/// Follows the ray through null interfaces. @return whether it hits another, lit surface.
bool SubpathTracer::next_surface(Subpath& path) {
    const Scene& scene = pass_.scene.scene;
    while (true) {
        ++rays_;
        const bool met = scene.geometry().complete(ray_hit_, hit_);
        if (scene.has_media())
            throughput_ *= pass_.scene.transmittance(
                medium_, {from_, direction_, met ? hit_.distance : kInfinity});
        if (transport_ == Transport::radiance) note_lights(met, path);
        if (!met) return false;
        const bool is_lit = !(hit_.distance < unlit_ || hit_.distance > lit_to_);
        unlit_ -= hit_.distance;
        lit_to_ -= hit_.distance;
        if (!scene.is_null_interface(hit_)) return is_lit;
        medium_ = scene.medium_beyond(hit_, direction_, medium_);
        const Ray ray = ray_from(hit_, direction_);
        from_ = ray.origin;
        ray_hit_ = scene.geometry().trace(ray);
    }
}

void SubpathTracer::note_lights(bool met, Subpath& path) {
    const Scene& scene = pass_.scene.scene;
    const std::size_t vertices = path.vertices.size();
    if (met) {
        const std::uint32_t i = scene.light_of(hit_);
        if (i == kNone) return;
        const auto& light = std::get<AreaLight>(scene.lights()[i]);
        if (!light.emits(hit_.normal, -direction_)) return;
        path.lights.push_back({vertices,
                               i,
                               {Vec3d(hit_.position), hit_.normal, -Vec3d(direction_)},
                               throughput_ * pass_.scene.emitted(i, light, hit_)});
        return;
    }
    const Vec3 last = vertices == 0 ? Vec3(start_.origin) : path.vertices.back().hit.position;
    for (const std::uint32_t i : scene.infinite_lights()) {
        const EnvironmentRadiance seen = environment_radiance(scene.lights()[i], last, direction_);
        if (!(seen.factor > 0)) continue;
        const SampledSpectrum light =
            pass_.scene.coloured(pass_.scene.emission[i] * seen.factor, seen.rgb);
        path.lights.push_back(
            {vertices, i, {Vec3d(last), Vec3(0), -Vec3d(direction_)}, throughput_ * light});
    }
}

/// Returns the vertex at the hit surface.
SubpathVertex SubpathTracer::vertex_at_hit(const Subpath& path) {
    const Vec3 came = direction_;
    Bsdf bsdf = vertex_bsdf(pass_.scene, hit_, throughput_, hero_);
    const Frame frame(hit_.shading_normal, hit_.tangent);
    SubpathVertex vertex{hit_,    frame, bsdf, frame.to_local(-came), 1, throughput_, hero_,
                         medium_, {},    {}};
    if (transport_ == Transport::flux) vertex.adjoint = adjoint_at(vertex, came);
    if (!path.vertices.empty()) {
        const SubpathVertex& last = path.vertices.back();
        const double distance2 = (Vec3d(hit_.position) - Vec3d(last.hit.position)).length2();
        vertex.weights = next_weights(last.weights, last.leaving, cosine_at(last.hit, came),
                                      cosine_at(hit_, came), distance2);
    } else if (transport_ == Transport::flux) {
        vertex.weights = first_of_light(end_densities(pass_.scene.scene, light_, start_, hit_));
    } else if (const auto sight = camera_.sight_of(Vec3d(hit_.position), lens_)) {
        vertex.weights = first_of_camera(sight->area * cosine_at(hit_, came), light_paths_);
    }
    return vertex;
}

/// Samples a direction. @return whether there is one.
bool SubpathTracer::scatter(PathNumbers& numbers, SubpathVertex& vertex, std::size_t depth) {
    const BsdfSampleInput draw{
        {below_one(numbers.next()), below_one(numbers.next()), below_one(numbers.next())},
        transport_,
        hero_};
    const auto drawn = sample(vertex.bsdf, vertex.wo, draw);
    if (!drawn) return false;
    const Vec3 came = direction_;
    direction_ = vertex.frame.to_world(drawn->wi);
    if (drawn->pdf)
        vertex.leaving = {*drawn->pdf, pdf(vertex.bsdf, drawn->wi, vertex.wo, other(transport_)),
                          false};
    else
        vertex.leaving = {cosine_at(vertex.hit, direction_), cosine_at(vertex.hit, came), true};
    const SampledSpectrum before = throughput_;
    throughput_ *= drawn->weight;
    if (transport_ == Transport::flux)
        throughput_ *= vertex.adjoint * std::abs(direction_.dot(vertex.hit.normal) / drawn->wi.z);
    scale_ *= drawn->eta * drawn->eta;
    if (drawn->dispersed) hero_.single = true;
    if (throughput_.is_zero()) return false;
    if (depth > 2) {
        const float survives = survival(before);
        if (!(numbers.next() < static_cast<double>(survives))) return false;
        throughput_ /= survives;
    }
    medium_ = pass_.scene.scene.medium_beyond(vertex.hit, direction_, medium_);
    const Ray ray = ray_from(vertex.hit, direction_);
    from_ = ray.origin;
    lit_to_ = kInfinity;
    ray_hit_ = pass_.scene.scene.geometry().trace(ray);
    return true;
}

/// Importance decreases like radiance; flux stays about constant.
float SubpathTracer::survival(const SampledSpectrum& before) const {
    return std::min(1.0F, transport_ == Transport::radiance ? throughput_.mean() * scale_
                                                            : throughput_.sum() / before.sum());
}

}  // namespace sunfleck::engine
