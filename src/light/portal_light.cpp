// Portal light: lines through a rectangle.
#include "light/portal_light.h"

namespace sunfleck::engine {

Vec3d PortalLight::to_local(const Vec3d& v) const {
    return {frame.x.dot(v), frame.y.dot(v), frame.z.dot(v)};
}

/// Returns the portal as the point sees it; nothing from its plane or from outside.
std::optional<PortalWindow> PortalLight::window(const Vec3& from) const {
    const Vec3d corner = to_local(frame.origin - Vec3d(from));
    if (!(corner.z > 0)) return {};
    return PortalWindow{portal_place(corner), portal_place(corner + Vec3d(extent.x, extent.y, 0))};
}

Emission PortalLight::sample_emission(const EmissionDimensions& u,
                                      const SceneSphere& sphere) const {
    const LightImage::Drawn drawn = image->through().draw({u[2], u[3]});
    const PortalDirection out = portal_direction(drawn.place);
    const Vec3d direction = -frame.vector(out.w);
    const Vec3d through = frame.point({u[0] * extent.x, u[1] * extent.y, 0});
    // Moves the origin back to before the line enters the scene.
    const double ahead = std::max(0.0, (through - sphere.center).dot(direction) + sphere.radius);
    Emission emission{
        through - direction * ahead,
        direction,
        extent.x * extent.y * drawn.light.luminance * out.w.z * out.solid_angle / drawn.density,
        Vec3(0),
        0,
        drawn.light.rgb};
    emission.unlit = ahead;
    return emission;
}

EmissionDimensions PortalLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const Vec3d out = to_local(-ray.direction);
    const Vec3d from = to_local(ray.origin - frame.origin);
    if (!(out.z > 0)) return {0.5, 0.5, 0.5, 0.5};
    const Vec3d through = from - out * (from.z / out.z);
    const Vec2d way = image->through().numbers(portal_place(out));
    return {through.x / extent.x, through.y / extent.y, way.x, way.y};
}

double PortalLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const Vec3d out = to_local(-ray.direction);
    if (!(out.z > 0)) return 0;
    const Vec2d uv = portal_place(out);
    return image->through().density(uv) /
           (portal_direction(uv).solid_angle * out.z * extent.x * extent.y);
}

std::optional<DirectSample> PortalLight::sample_direct(const Vec3& point, const Vec2& u,
                                                       const SceneSphere&) const {
    const auto seen = window(point);
    const auto drawn = seen ? image->draw(*seen, Vec2d(u)) : std::nullopt;
    if (!drawn || !(drawn->density > 0)) return {};
    const PortalDirection out = portal_direction(drawn->uv);
    const double pdf = drawn->density / out.solid_angle;
    return DirectSample{Vec3(frame.vector(out.w)), kInfinity,
                        static_cast<float>(drawn->light.luminance / pdf), static_cast<float>(pdf),
                        drawn->light.rgb};
}

double PortalLight::power(const SceneSphere&) const {
    return extent.x * extent.y * image->through().mean();
}

EnvironmentRadiance PortalLight::environment_radiance(const Vec3& from,
                                                      const Vec3& direction) const {
    const Vec3d w = to_local(Vec3d(direction));
    const auto seen = w.z > 0 ? window(from) : std::nullopt;
    if (!seen) return {};
    const Vec2d uv = portal_place(w);
    if (!seen->contains(uv)) return {};
    const TexelLight light = image->through().at(uv);
    const double pdf = image->density(*seen, uv) / portal_direction(uv).solid_angle;
    return {static_cast<float>(light.luminance), static_cast<float>(pdf), light.rgb};
}

}  // namespace sunfleck::engine
