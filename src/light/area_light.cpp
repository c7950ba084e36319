// Area lights: emission by position and cosine; direct light by visible cap or by area.
#include "light/area_light.h"

#include "light/emitting_surface.h"
#include "light/partial_emitter.h"
#include "light/surface_image.h"
#include "math/warp.h"

namespace sunfleck::engine {

namespace {

/// Samples a direction to the visible cap of a full sphere, with the distance.
DirectSample sample_cap(const VisibleCap& cap, const Vec2d& u) {
    const DiscPoint disc = concentric_disc_point(u);
    const double versine = disc.radius2 * cap.versine;
    const Vec3d direction = rotate_z_to(cap.axis, around_pole(disc, versine));
    const double across2 = cap.distance * cap.distance * versine * (2 - versine);
    const double half_chord = std::sqrt(std::max(0.0, cap.radius * cap.radius - across2));
    const double solid_angle = 2 * kPiDouble * cap.versine;
    const double distance = cap.distance * (1 - versine) - half_chord;
    DirectSample drawn{Vec3(direction), static_cast<float>(distance),
                       static_cast<float>(solid_angle), static_cast<float>(1 / solid_angle)};
    drawn.normal = Vec3((direction * distance - cap.axis * cap.distance) / cap.radius);
    return drawn;
}

/// Samples a direction to a point of the whole surface; nothing if it emits to the other side.
std::optional<DirectSample> sample_by_area(const SurfaceSample& on, const Vec3d& point,
                                           bool two_sided) {
    const Vec3d to_light = on.position - point;
    const double distance2 = to_light.length2();
    if (!(distance2 > 0)) return {};
    const double distance = std::sqrt(distance2);
    const double cosine = -on.normal.dot(to_light) / distance;
    const double facing = two_sided ? std::abs(cosine) : cosine;
    if (!(facing > 0)) return {};
    const double solid_angle = on.spread * facing / distance2;
    const auto pdf = static_cast<float>(1 / solid_angle);
    if (!std::isfinite(pdf)) return {};
    return DirectSample{Vec3(to_light / distance),
                        static_cast<float>(distance),
                        static_cast<float>(solid_angle),
                        pdf,
                        {},
                        Vec3(on.normal)};
}

}  // namespace

Emission AreaLight::sample_emission(const EmissionDimensions& u, const SceneSphere&) const {
    PlacedImage::Drawn from;
    if (image) {
        from = image->draw(surface, {u[0], u[1]});
    } else {
        from = {sample_surface(surface, {u[0], u[1]}), {1, Vec3(1)}, 1};
    }
    const SurfaceSample& on = from.on;
    const auto bound = [&](const auto& s) { return surface_error(s, on); };
    const bool back = two_sided && u[2] > 0.5;
    // The two sides are the halves of the dimension, folded so that they meet at the horizon.
    const double folded = two_sided ? 2 * std::min(u[2], 1 - u[2]) : u[2];
    Vec3d local = cosine_hemisphere({folded, u[3]});
    if (back) local.z = -local.z;
    const double sides = two_sided ? 2 : 1;
    Emission emission{on.position, rotate_z_to(on.normal, local), sides * kPiDouble * on.spread,
                      Vec3(on.normal), std::visit(bound, surface)};
    if (alpha) emission.factor *= alpha->at(surface, on.position, on.normal);
    const auto within = [&](const auto& s) {
        return way_within(s, emission.origin, emission.direction);
    };
    if (unseen) emission.lit_to = std::visit(within, surface);
    if (!image) return emission;
    emission.factor *= from.light.luminance / from.density;
    emission.rgb = from.light.rgb;
    return emission;
}

EmissionDimensions AreaLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const Vec3d normal(ray.normal);
    const Vec2d place = image ? image->numbers(surface, ray.origin, normal)
                              : surface_square(surface, ray.origin, normal);
    const Vec3d local = rotate_to_z(normal, ray.direction);
    const Vec2d way = disc_to_square({local.x, local.y});
    const double folded = two_sided ? way.x / 2 : way.x;
    return {place.x, place.y, two_sided && local.z < 0 ? 1 - folded : folded, way.y};
}

double AreaLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const Vec3d n(ray.normal);
    const double cosine = n.dot(ray.direction);
    if (!(two_sided ? cosine != 0 : cosine > 0)) return 0;
    const auto spread_of = [&](const auto& s) { return surface_spread(s, ray.origin, n); };
    const double spread = std::visit(spread_of, surface);
    const double by_area = image ? image->density(surface, ray.origin, n, spread) : 1 / spread;
    return by_area * std::abs(cosine) / (kPiDouble * (two_sided ? 2 : 1));
}

std::optional<DirectSample> AreaLight::sample_direct(const Vec3& point, const Vec2& u,
                                                     const SceneSphere&) const {
    const Vec3d from(point);
    const auto sample = [&](const auto& s) -> std::optional<DirectSample> {
        if (const auto cap = visible_cap(s, from)) {
            if (is_flipped(s) && !two_sided) return {};
            DirectSample drawn = sample_cap(*cap, Vec2d(u));
            if (is_flipped(s)) drawn.normal = -drawn.normal;
            return drawn;
        }
        return sample_by_area(sample_surface(s, Vec2d(u)), from, two_sided);
    };
    std::optional<DirectSample> drawn = std::visit(sample, surface);
    if (drawn && unseen) drawn->pdf.reset();
    if (!drawn || !(image || alpha)) return drawn;
    const Vec3d towards(drawn->direction);
    const Vec3d on = from + towards * static_cast<double>(drawn->distance);
    if (alpha) drawn->factor *= alpha->at(surface, on, towards);
    if (!(drawn->factor > 0)) return {};
    if (!image) return drawn;
    const TexelLight light = image->at(surface, on, towards);
    if (!(light.luminance > 0)) return {};
    drawn->factor *= static_cast<float>(light.luminance);
    drawn->rgb = light.rgb;
    return drawn;
}

double AreaLight::power(const SceneSphere&) const {
    return (two_sided ? 2 : 1) * kPiDouble * (image ? image->flux() : area()) *
           (alpha ? alpha->mean() : 1);
}

TexelLight AreaLight::light_at(const Vec2& uv) const {
    return image ? image->at(uv) : TexelLight{1, Vec3(1)};
}

double AreaLight::area() const {
    return std::visit([](const auto& s) { return surface_area(s); }, surface);
}

float AreaLight::direct_pdf(const Vec3& point, const Vec3& on, const Vec3& normal) const {
    const Vec3d to_point = Vec3d(point) - Vec3d(on);
    const Vec3d n(normal);
    const double facing = n.dot(to_point);
    const double distance2 = to_point.length2();
    if (!(distance2 > 0) || !(two_sided ? facing != 0 : facing > 0)) return 0;
    const auto density = [&](const auto& s) {
        if (const auto cap = visible_cap(s, Vec3d(point))) {
            const bool outside = is_flipped(s) ? facing < 0 : facing > 0;
            return outside ? 1 / (2 * kPiDouble * cap->versine) : 0.0;
        }
        const double cosine = std::abs(facing) / std::sqrt(distance2);
        return distance2 / (cosine * surface_spread(s, Vec3d(on), n));
    };
    return static_cast<float>(std::visit(density, surface));
}

}  // namespace sunfleck::engine
