// Portal light: lines through a rectangle.
#include "light/portal_light.h"

namespace sunfleck::engine {

Vec3d PortalLight::to_local(const Vec3d& v) const {
    return {frame.x.dot(v), frame.y.dot(v), frame.z.dot(v)};
}

/// The portal as the point sees it; nothing from beside it or from outside.
std::optional<PortalWindow> PortalLight::window(const Vec3& from) const {
    const Vec3d corner = to_local(frame.origin - Vec3d(from));
    if (!(corner.z > 0)) return {};
    return PortalWindow{portal_place(corner), portal_place(corner + Vec3d(extent.x, extent.y, 0))};
}

Emission PortalLight::sample_emission(const std::array<double, 4>& u,
                                      const SceneSphere& sphere) const {
    const LightPicture::Drawn drawn = picture->through().draw({u[2], u[3]});
    const PortalDirection out = portal_direction(drawn.place);
    const Vec3d direction = -frame.vector(out.w);
    const Vec3d through = frame.point({u[0] * extent.x, u[1] * extent.y, 0});
    // Back to where the line has not met the scene yet.
    const double ahead = std::max(0.0, (through - sphere.center).dot(direction) + sphere.radius);
    Emission emission{
        through - direction * ahead,
        direction,
        extent.x * extent.y * drawn.light.luminance * out.w.z * out.solid_angle / drawn.density,
        Vec3(0),
        0,
        drawn.light.tint};
    emission.unlit = ahead;
    return emission;
}

EmissionDimensions PortalLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const Vec3d out = to_local(-ray.direction);
    const Vec3d from = to_local(ray.origin - frame.origin);
    if (!(out.z > 0)) return {0.5, 0.5, 0.5, 0.5};
    const Vec3d through = from - out * (from.z / out.z);
    const Vec2d way = picture->through().numbers(portal_place(out));
    return {through.x / extent.x, through.y / extent.y, way.x, way.y};
}

double PortalLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const Vec3d out = to_local(-ray.direction);
    if (!(out.z > 0)) return 0;
    const Vec2d uv = portal_place(out);
    return picture->through().density(uv) /
           (portal_direction(uv).solid_angle * out.z * extent.x * extent.y);
}

std::optional<DirectSample> PortalLight::sample_direct(const Vec3& point, const Vec2& u,
                                                       const SceneSphere&) const {
    const auto seen = window(point);
    const auto drawn = seen ? picture->draw(*seen, Vec2d(u)) : std::nullopt;
    if (!drawn || !(drawn->density > 0)) return {};
    const PortalDirection out = portal_direction(drawn->uv);
    const double pdf = drawn->density / out.solid_angle;
    return DirectSample{Vec3(frame.vector(out.w)), kInfinity,
                        static_cast<float>(drawn->light.luminance / pdf), static_cast<float>(pdf),
                        drawn->light.tint};
}

double PortalLight::power(const SceneSphere&) const {
    return extent.x * extent.y * picture->through().mean();
}

Beyond PortalLight::beyond(const Vec3& from, const Vec3& direction) const {
    const Vec3d w = to_local(Vec3d(direction));
    const auto seen = w.z > 0 ? window(from) : std::nullopt;
    if (!seen) return {};
    const Vec2d uv = portal_place(w);
    if (!seen->contains(uv)) return {};
    const TexelLight light = picture->through().at(uv);
    const double pdf = picture->density(*seen, uv) / portal_direction(uv).solid_angle;
    return {static_cast<float>(light.luminance), static_cast<float>(pdf), light.tint};
}

}  // namespace sunfleck::engine
