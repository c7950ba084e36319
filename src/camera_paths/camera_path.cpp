// Traces one camera path, with the path-space partition of its light (docs/method/method.md,
// owners).
#include "camera_paths/camera_path.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Russian roulette begins after this many events, because short paths contribute most.
constexpr int kRouletteFrom = 4;

/// Both lobes of smooth glass are traced if neither has a smaller weight in the pixel.
constexpr float kLeastBranch = 0.002F;

/// Growth of the footprint's angle at a glossy surface, as a fraction of the lobe's width (the
/// square root of the sampled solid angle, at most one). Objects behind it are blurred by the whole
/// lobe, so gather discs of a hundredth of it add no visible blur; discs of the pixel's size would
/// find few photons.
constexpr float kGlossySpread = 0.01F;

}  // namespace

void CameraPath::trace(std::uint32_t pixel, const PathOfPixel& path) {
    pixel_ = pixel;
    of_pixel_ = 1 / static_cast<float>(path.count());
    BatchPoints numbers(pass_.id, pixel, path);
    const CameraRay ray = start(numbers);
    follow(pass_.scene.scene.first_hit(ray), numbers);
}

/// @param hit  what the ray hits, if anything.
void CameraPath::follow(std::optional<Hit> hit, BatchPoints& numbers) {
    const Scene& scene = pass_.scene.scene;
    while (true) {
        ++statistics_[Count::camera_rays];
        if (scene.has_media()) {
            const Crossing crossing = cross_medium(hit, numbers);
            if (crossing == Crossing::ended) return;
            if (crossing == Crossing::scattered) continue;
        }
        if (!hit) {
            if (!has_features_) add_transmittance();
            add_emission(
                environment_along(pass_.scene, position_, direction_, wanted_contributions()));
            return;
        }
        grow_footprint(hit->distance);
        const bool weighted = emitters_ == Emitters::weighted;
        add_emission(emitter_at(pass_.scene, *hit, weighted ? &glossy_ : nullptr, direction_,
                                wanted_contributions()));
        if (!scene.is_null_interface(*hit)) {
            if (!has_hit_) first_footprint_ = footprint_;
            has_hit_ = true;
            if (!interact(*hit, numbers)) return;
        }
        hit = scene.geometry().intersect(ray_beyond(*hit));
    }
}

Ray CameraPath::ray_beyond(const Hit& hit) {
    medium_ = pass_.scene.scene.medium_beyond(hit, direction_, medium_);
    const Ray ray = ray_from(hit, direction_);
    from_ = ray.origin;
    return ray;
}

CameraRay CameraPath::start(BatchPoints& numbers) {
    const FilterSample filtered = filter_.sample(numbers.next_2d());
    const Vec2d film = pass_.window.place(pixel_, filtered.offset);
    CameraRay ray = camera_ray(pass_.scene.scene.camera(), film, numbers.next_2d());
    weight_ = filtered.weight * pass_.scene.scene.film().imaging_ratio * of_pixel_;
    throughput_ = SampledSpectrum(1);
    medium_ = pass_.scene.scene.media().at_camera;
    hero_.chosen = hero_of(numbers.next());
    direction_ = Vec3(ray.direction);
    footprint_ = ray.footprint;
    footprint_angle_ = ray.footprint_angle;
    position_ = from_ = Vec3(ray.origin);
    return ray;
}

/// @return whether the path continues, in the new direction.
bool CameraPath::interact(Hit& hit, BatchPoints& numbers) {
    const TransportSettings& transport = pass_.transport;
    std::optional<Bsdf> room;
    const Bsdf& at_surface = pass_.scene.bsdf_at(hit, room);
    const Scattering kind = scattering(at_surface);
    std::optional<Bsdf> narrowed;
    if (is_dispersive(at_surface)) {
        if (kind != Scattering::specular) terminate_secondary(throughput_, hero_);
        if (hero_.single) narrowed = at_wavelength(at_surface, hero_.chosen);
    }
    const Frame frame(hit.shading_normal, hit.tangent);
    const bool several = pass_.settings.ris;
    const Bsdf& bsdf = narrowed ? *narrowed : at_surface;
    const CameraVertex vertex{hit, frame, frame.to_local(-direction_), bsdf, medium_, several};
    if (bounces_ >= transport.max_depth) return false;
    if (beyond_) return interact_beyond(vertex, at_surface, numbers);
    if (const auto* coated = std::get_if<CoatedDiffuse>(&at_surface)) {
        const Bsdf base = coated->base();
        const Bsdf top = coated->top();
        gather_at_base({hit, frame, vertex.wo, base, medium_, several}, numbers);
        return go_on({hit, frame, vertex.wo, top, medium_, several}, numbers);
    }
    if (kind == Scattering::diffuse) {
        gather_at_base(vertex, numbers);
        return false;
    }
    return go_on(vertex, numbers);
}

/// Ends the path at a diffuse lobe.
void CameraPath::gather_at_base(const CameraVertex& vertex, BatchPoints& numbers) {
    const bool sampled = pass_.transport.direct == DirectLight::sampled;
    gather(vertex.hit, vertex.bsdf, sampled ? kScatteredKinds : kAllKinds);
    const bool goes_beyond = pass_.transport.goes_beyond_diffuse();
    if (sampled) add_direct_light(vertex, numbers, !goes_beyond);
    add_features(vertex.hit, diffuse_albedo(vertex.bsdf, vertex.wo));
    if (goes_beyond) CameraPath(*this).go_beyond(vertex, numbers.branch());
}

/// Continues the path from a specular or glossy lobe. @return whether it does.
bool CameraPath::go_on(const CameraVertex& vertex, BatchPoints& numbers) {
    const bool sampled = pass_.transport.direct == DirectLight::sampled;
    if (scattering(vertex.bsdf) == Scattering::glossy) {
        gather(vertex.hit, vertex.bsdf, sampled ? kCausticKinds : kAllKinds);
        if (!sampled) return false;
        add_direct_light(vertex, numbers, false);
    }
    return scatter(vertex, numbers);
}

void CameraPath::add_emission(const EmitterHit& met) {
    if (met.radiance.is_zero() || emitters_ == Emitters::none) {
        contributions_.clear();
        return;
    }
    const float weight = emitters_ == Emitters::all ? 1 : mis_weight(bsdf_pdf_, met.pdf);
    add_light(met.radiance, weight, owner_of_emission());
}

/// Returns the AOV of what emits at the end of this path.
Aov CameraPath::owner_of_emission() const {
    constexpr std::array<Aov, 3> kOwners = {Aov::emission, Aov::direct, Aov::indirect};
    return kOwners.at(std::min<std::size_t>(rough_, 2));
}

void CameraPath::add_light(const SampledSpectrum& radiance, float weight, Aov owner) {
    const auto rgb = [&](const SampledSpectrum& arriving) {
        return pass_.scene.wavelengths.to_rgb(throughput_ * arriving * weight * weight_);
    };
    image_.add_camera_light(pixel_, rgb(radiance), owner);
    for (const LightContribution& part : contributions_)
        image_.add_to_light_group(pixel_, rgb(part.radiance),
                                  pass_.transport.light_groups.of(part.light));
    contributions_.clear();
}

/// @param follow  trace a bsdf sample for MIS (a path that continues needs none).
/// @return whether any light arrives.
bool CameraPath::add_direct_light(const CameraVertex& vertex, BatchPoints& numbers, bool follow) {
    const PassScene& pass = pass_.scene;
    const Vec2d choices = numbers.next_2d();
    SampledSpectrum light = sample_lights(pass, vertex, {choices.x, numbers.next_2d(), choices.y},
                                          statistics_, wanted_contributions());
    if (follow && pass.scene.has_lights_to_hit()) {
        const Vec2d u = numbers.next_2d();
        const BsdfSampleInput draw{
            {static_cast<float>(numbers.next()), static_cast<float>(u.x), static_cast<float>(u.y)},
            Transport::radiance,
            hero_};
        if (const auto drawn = sample(vertex.bsdf, vertex.wo, draw))
            light += follow_bsdf_sample(pass, vertex, *drawn, statistics_, wanted_contributions());
    }
    if (light.is_zero()) return false;
    add_light(light, 1, rough_ > 0 ? Aov::indirect : Aov::direct);
    return true;
}

bool CameraPath::scatter(const CameraVertex& vertex, BatchPoints& numbers) {
    const Vec2d u = numbers.next_2d();
    const Vec2d choices = numbers.next_2d();
    BsdfSampleInput draw{
        {static_cast<float>(choices.x), static_cast<float>(u.x), static_cast<float>(u.y)},
        Transport::radiance,
        hero_};
    const float mirrored = reflection_probability(vertex.bsdf, vertex.wo, hero_);
    if (beyond_ || importance() * std::min(mirrored, 1 - mirrored) < kLeastBranch)
        return take(vertex, draw, 1, choices.y);
    draw.u.x = 0.5F * mirrored;
    add_features(vertex.hit, SampledSpectrum(1));  // all of it is reflected or refracted
    const Geometry& geometry = pass_.scene.scene.geometry();
    CameraPath branch = *this;
    BatchPoints others = numbers.branch();
    if (branch.take(vertex, draw, mirrored, choices.y))
        branch.follow(geometry.intersect(branch.ray_beyond(vertex.hit)), others);
    draw.u.x = 0.5F * (1 + mirrored);
    return take(vertex, draw, 1 - mirrored, choices.y);
}

bool CameraPath::take(const CameraVertex& vertex, const BsdfSampleInput& draw, float share,
                      double roulette) {
    const auto drawn = sample(vertex.bsdf, vertex.wo, draw);
    if (!drawn) return false;
    add_features(vertex.hit, drawn->weight * (drawn->eta * drawn->eta));
    throughput_ *= drawn->weight * share;
    share_ *= share;
    if (drawn->dispersed) hero_.single = true;
    eta_scale_ *= drawn->eta * drawn->eta;
    footprint_angle_ /= drawn->eta;
    spread_angle_ /= drawn->eta;
    if (drawn->pdf) spread_angle_ += kGlossySpread * std::min(1.0F, 1 / std::sqrt(*drawn->pdf));
    ++bounces_;
    if (beyond_) ++events_beyond_;
    const bool others_bring_it = beyond_ && scattering(vertex.bsdf) != Scattering::diffuse;
    if (drawn->pdf && !others_bring_it) {
        emitters_ = Emitters::weighted;
        bsdf_pdf_ = *drawn->pdf / static_cast<float>(ris_candidates(vertex));
        glossy_ = receiver_at(pass_.scene.scene, vertex);
        ++rough_;
    } else if (emitters_ == Emitters::weighted) {
        emitters_ = Emitters::none;
    }
    direction_ = vertex.frame.to_world(drawn->wi);
    position_ = vertex.hit.position;
    if (bounces_ < kRouletteFrom) return !throughput_.is_zero();
    // The survival probability is relative to the branch. Ended like other paths, a branch would
    // contribute in flashes as bright as a whole pixel; without roulette, it would cost as much as
    // a whole path.
    const float survival = std::min(1.0F, std::max(0.0F, importance() / std::sqrt(share_)));
    if (!(roulette < survival)) return false;
    throughput_ /= survival;
    return true;
}

float CameraPath::importance() const {
    return throughput_.sum() * eta_scale_ / static_cast<float>(kWavelengths);
}

/// Adds the features of the first surface; for a coated one, of the base.
/// @param reflectance  fraction of each wavelength that the surface scatters.
void CameraPath::add_features(const Hit& hit, const SampledSpectrum& reflectance) {
    if (has_features_) return;
    has_features_ = true;
    const auto add = [&](const Vec3& value, Aov aov) {
        image_.add_feature(pixel_, value * of_pixel_, aov);
    };
    add_transmittance();
    add(hit.shading_normal, Aov::normal);
    add(Vec3(length_), Aov::depth);
    if (image_.has(Aov::albedo))
        add(pass_.scene.wavelengths.to_rgb(reflectance * pass_.scene.white), Aov::albedo);
}

}  // namespace sunfleck::engine
