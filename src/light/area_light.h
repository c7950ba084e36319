// AreaLight: a surface (light/emitting_surface.h) with diffuse emission on one or both sides,
// optionally textured by an image.
//
// Spectrum: radiance, W/(sr m^2); with an image, at texels of value one.
// Emission: positions by the image's brightness, else uniform by area (for spheres and cylinders
// under non-similarities: in their own frame; for patches that are not planar: approximately);
// cosine-weighted directions. Two-sided emitters select the side by the halves of the first
// direction dimension, folded so that they meet at the horizon; Emission::normal stays on the side
// of Hit::normal.
// Direct light: full spheres under similarities are sampled in the cone that the point sees (by
// area from inside), everything else by area.
#pragma once

#include "light/emitting_surface.h"
#include "light/light_image.h"
#include "light/model.h"

#include <memory>

namespace sunfleck::engine {

class PlacedImage;     // light/surface_image.h
class PartialEmitter;  // light/partial_emitter.h

struct AreaLight {
    static constexpr std::string_view name = "area";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;
    EmittingSurface surface;
    bool two_sided = false;
    std::uint32_t shape = kNone;      // Hit::shape of the surface
    std::uint32_t primitive = kNone;  // Hit::primitive
    /// The light emits, but rays do not hit its surface (alpha zero): light samples bring all its
    /// light.
    bool unseen = false;
    /// Image that multiplies the radiance over the surface; null for none.
    std::shared_ptr<const PlacedImage> image = nullptr;
    /// Alpha of the surface; null if opaque.
    std::shared_ptr<const PartialEmitter> alpha = nullptr;

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    /// Returns pi * area, twice if two-sided, times the means of image and alpha over the surface.
    double power(const SceneSphere&) const;
    /// Returns the area in m^2, in the world; by quadrature if there is no closed form.
    double area() const;
    /// Returns whether the surface emits into w (unit, world, pointing away). @param normal  of the
    /// hit.
    bool emits(const Vec3& normal, const Vec3& w) const { return two_sided || normal.dot(w) > 0; }
    /// Returns the radiance relative to the spectrum at a hit. @param uv  of the hit.
    TexelLight light_at(const Vec2& uv) const;
    /// Returns the density per steradian at `point` with which sample_direct() chooses the surface
    /// point `on` with geometric normal `normal`; for MIS weights.
    float direct_pdf(const Vec3& point, const Vec3& on, const Vec3& normal) const;
};

}  // namespace sunfleck::engine
