// PortalLight: an environment map that is visible through a rectangular portal alone.
//
// Spectrum: radiance for a texel of one, W/(sr m^2). A point sees the environment in the directions
// in which it looks through the portal from inside, and nothing in others. Photons start outside
// the scene, on lines through points uniform on the portal, with directions by radiance times
// cosine. What a photon hits before the portal stops it, as it stops a ray from inside.
// Source: pbrt-v4's portal light, for its emission.
#pragma once

#include "geometry/affine.h"
#include "light/model.h"
#include "light/portal_image.h"

#include <memory>

namespace sunfleck::engine {

struct PortalLight {
    static constexpr std::string_view name = "infinite with a portal";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    std::shared_ptr<const PortalImage> image;
    Affine frame;  // orthonormal; the origin is a corner of the portal, z points out to the
                   // environment
    Vec2d extent;  // of the portal from the corner along x and y; positive

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;
    EnvironmentRadiance environment_radiance(const Vec3& from, const Vec3& direction) const;

private:
    std::optional<PortalWindow> window(const Vec3& from) const;
    Vec3d to_local(const Vec3d& v) const;
};

}  // namespace sunfleck::engine
