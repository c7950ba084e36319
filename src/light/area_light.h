// A light that emits from a surface (light/emitting_surface.h), the same radiance in all directions
// of one side, or of both. A picture may vary it from place to place.
//
// Curve: radiance, W/(sr m^2); with a picture, where that is one.
// Emission: with a picture, from where that is bright; else uniform by area (spheres and cylinders
// under matrices that are no similarity: in their own frame; patches that are not flat: nearly),
// cosine-weighted directions. Two-sided emitters choose the side by the halves of the first
// direction dimension, folded so that they meet at the horizon; Emission::normal stays on the side
// of Hit::normal. Direct light: whole spheres under similarities are sampled in the cone that the
// point sees (by area from inside), all else by area.
#pragma once

#include "light/emitting_surface.h"
#include "light/light_picture.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

class LaidPicture;     // light/surface_picture.h
class PartialEmitter;  // light/partial_emitter.h

struct AreaLight {
    static constexpr std::string_view name = "area";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    EmittingSurface surface;
    bool two_sided = false;
    std::uint32_t shape = kNone;      // Hit::shape of the surface
    std::uint32_t primitive = kNone;  // Hit::primitive
    /// It shines, but nothing is there: rays do not meet it, so light samples must bring it all.
    bool unseen = false;
    /// What the radiance is multiplied by, over the surface; null: one.
    std::shared_ptr<const LaidPicture> picture = nullptr;
    /// How much of the surface is there; null: all of it.
    std::shared_ptr<const PartialEmitter> alpha = nullptr;

    Emission sample_emission(const std::array<double, 4>& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    /// pi * area, twice if two-sided; times the means of picture and alpha over the surface.
    double power(const SceneSphere&) const;
    /// In m^2, in the world. By quadrature where there is no closed form.
    double area() const;
    /// Does the surface emit into w (unit, world, away from it)? @param normal  of the hit.
    bool emits(const Vec3& normal, const Vec3& w) const { return two_sided || normal.dot(w) > 0; }
    /// Radiance over the curve where the surface is met. @param uv  of the hit.
    TexelLight light_at(const Vec2& uv) const;
    /// Density per steradian at `point` with which sample_direct() would choose the point `on`
    /// of the surface (whose geometric normal is `normal`): the other half of MIS.
    float direct_pdf(const Vec3& point, const Vec3& on, const Vec3& normal) const;
};

}  // namespace sunfleck::engine
