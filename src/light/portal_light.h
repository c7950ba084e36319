// Light from infinitely far away that comes through a rectangular portal alone.
//
// Curve: radiance where the picture is one, W/(sr m^2). A point sees the sky in the directions in
// which it looks through the portal from inside, and nothing in others. Photons start outside the
// scene, on lines through points spread evenly over the portal, in directions by radiance times
// cosine; what they meet before the portal stops them, as it stops the look from within.
// Source: pbrt-v4's light of that kind, for what it shines.
#pragma once

#include "geometry/affine.h"
#include "light/model.h"
#include "light/portal_picture.h"

#include <memory>

namespace sunfleck::engine {

struct PortalLight {
    static constexpr std::string_view name = "infinite with a portal";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    std::shared_ptr<const PortalPicture> picture;
    Affine frame;  // orthonormal; its origin a corner of the portal, z out to the sky
    Vec2d extent;  // of the portal, from the corner along x and along y; positive

    Emission sample_emission(const std::array<double, 4>& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere&) const;
    Beyond beyond(const Vec3& from, const Vec3& direction) const;

private:
    std::optional<PortalWindow> window(const Vec3& from) const;
    Vec3d to_local(const Vec3d& v) const;
};

}  // namespace sunfleck::engine
