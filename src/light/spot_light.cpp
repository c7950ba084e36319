// Spot light: directions sampled exactly by intensity, smooth edge included.
//
// With s = 1 - cos, the intensity is 1 up to s = 1 - cos_start and t^2 (3 - 2 t) or t^2 beyond,
// where t decreases from 1 to 0 over the edge. Its integral from the outside, over that of the
// edge, is 2 t^3 - t^4 or t^3: the quantile is a root of a quartic, or a cube root.
#include "light/spot_light.h"

#include "light/towards_point.h"
#include "math/warp.h"

#include <algorithm>

namespace sunfleck::engine {

namespace {

/// Returns the share of the edge's flux that is outside of t.
double share_outside(double t, SpotEdge edge) {
    return edge == SpotEdge::square ? t * t * t : t * t * t * (2 - t);
}

/// Returns the t in [0,1] outside of which there is a share g of the edge's flux. @param g  in
/// [0,1]. Newton's method starts above the root, where the function is convex, and decreases to it.
double edge_quantile(double g, SpotEdge edge) {
    if (!(g > 0)) return 0;
    const double root4 = std::sqrt(std::sqrt(g));
    const double root16 = std::sqrt(std::sqrt(root4));
    double t = root4 * root16;  // g^(5/16), above the root: at 1e-17 by a factor of three
    for (int step = 0; step < 9; ++step) {
        const double slope = t * t * (edge == SpotEdge::square ? 3 : 6 - 4 * t);
        t -= (share_outside(t, edge) - g) / slope;
    }
    return std::clamp(t, 0.0, 1.0);
}

/// The two parts of the emitted flux, in units of 2 pi times the intensity on the axis.
struct SpotFlux {
    double core;   // 1 - cos_start
    double width;  // of the edge, in cosines
    double edge;   // width times the mean over it

    explicit SpotFlux(const SpotLight& light)
        : core(1 - light.cos_start),
          width(light.cos_start - light.cos_total),
          edge(width / (light.edge == SpotEdge::square ? 3 : 2)) {}
    double total() const { return core + edge; }
};

}  // namespace

Emission SpotLight::sample_emission(const EmissionDimensions& u, const SceneSphere&) const {
    const SpotFlux flux(*this);
    const DiscPoint disc = concentric_disc_point({u[2], u[3]});
    double versine = disc.radius2 * flux.total();
    if (versine > flux.core && flux.edge > 0) {
        const double outside = (1 - disc.radius2) * flux.total() / flux.edge;
        versine = flux.core + flux.width * (1 - edge_quantile(std::min(outside, 1.0), edge));
    }
    const Vec3d direction = rotate_z_to(axis, around_pole(disc, versine));
    return {position, direction, 2 * kPiDouble * flux.total(), Vec3(0), 0};
}

EmissionDimensions SpotLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const SpotFlux flux(*this);
    const Vec3d local = rotate_to_z(axis, ray.direction);
    const double versine = 1 - local.z;
    double radius2 = versine / flux.total();
    if (versine > flux.core && flux.edge > 0) {
        const double t = std::clamp(1 - (versine - flux.core) / flux.width, 0.0, 1.0);
        radius2 = 1 - share_outside(t, edge) * flux.edge / flux.total();
    }
    const double flat2 = local.x * local.x + local.y * local.y;
    const double shrink = flat2 > 0 ? std::sqrt(std::clamp(radius2, 0.0, 1.0) / flat2) : 0;
    const Vec2d way = disc_to_square(Vec2d(local.x, local.y) * shrink);
    return {kUnread, kUnread, way.x, way.y};
}

double SpotLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    return falloff(axis.dot(ray.direction)) / (2 * kPiDouble * SpotFlux(*this).total());
}

std::optional<DirectSample> SpotLight::sample_direct(const Vec3& point, const Vec2&,
                                                     const SceneSphere&) const {
    const auto way = towards_point(position, point);
    if (!way) return {};
    const double intensity = falloff(-axis.dot(way->direction));
    if (!(intensity > 0)) return {};
    return DirectSample{Vec3(way->direction), static_cast<float>(way->distance),
                        static_cast<float>(intensity / way->distance2), std::nullopt};
}

double SpotLight::power(const SceneSphere&) const {
    return 2 * kPiDouble * SpotFlux(*this).total();
}

double SpotLight::falloff(double cos_angle) const {
    if (cos_angle >= cos_start) return 1;
    if (cos_angle <= cos_total) return 0;
    const double t = (cos_angle - cos_total) / (cos_start - cos_total);
    return edge == SpotEdge::square ? t * t : t * t * (3 - 2 * t);
}

}  // namespace sunfleck::engine
