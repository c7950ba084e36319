// The contribution of one photon to the radiance estimate at a visible point, in two factors.
//
// L = 1 / (N pi r^2 s) sum over photons of throughput * f(w, wo) * flux * |n_s.w| / |n_g.w|,
// with s the area of surface in the disc over that of the disc.
// Source: paper section 3.1 (progressive density estimation); Hachisuka and Jensen 2009, eq. 8,
// with one radius per pass; shading normals: photon density measures |n_g.w|, a bsdf |n_s.w|
// (Veach, Robust Monte Carlo Methods, 1997, section 5.3.2). n_g is the normal at the photon: beyond
// an edge of a mesh it differs from the point's, and the light there should be as bright as on this
// side.
#pragma once

#include "scene/pass_scene.h"
#include "visible_points/photon_chunk.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// Returns f at the visible point from the photon's side towards the camera, without the part that
/// the throughput already contains.
inline SampledSpectrum gather_lobe(const PassScene& pass, const VisiblePoint& point,
                                   const Vec3& w) {
    const Frame frame(point.shading_normal, point.tangent);
    const Bsdf& bsdf = pass.kept(point.bsdf);
    const Vec3 from = frame.to_local(point.wo);
    const Vec3 to = frame.to_local(w);
    if (point.single_wavelength && is_dispersive(bsdf))
        return eval(at_wavelength(bsdf, point.hero), from, to, Transport::radiance);
    return eval(bsdf, from, to, Transport::radiance);
}

/// Returns |n_s.w| / |n_g.w|; zero if light and camera are on different sides of the shading normal
/// of a Lambertian surface (other bsdfs handle that themselves).
inline float correction(const VisiblePoint& point, const Photon& photon) {
    if (point.is_flat()) return 1;
    const float cosine = point.shading_normal.dot(photon.w);
    const bool gathers = Lambert::gathers(point.shading_normal.dot(point.wo), cosine);
    if (point.bsdf == kLambertian && !gathers) return 0;
    return std::abs(cosine) / std::abs(photon.normal.dot(photon.w));
}

/// Returns what a medium leaves of light from a photon, on its way back through the cylinder of a
/// point.
inline SampledSpectrum left_in_cylinder(const PassScene& pass, const VisiblePoint& point,
                                        const Photon& photon) {
    const Vec3& along = point.disc.normal;
    const Vec3 begin = point.disc.position - along * point.disc.half_length;
    return pass.transmittance(point.medium, {begin, along, along.dot(photon.position - begin)});
}

/// Returns the factor that differs between photons: flux times the point's bsdf.
inline SampledSpectrum light_of(const PassScene& pass, const VisiblePoint& point,
                                const Photon& photon) {
    if (photon.in_medium)
        return photon.flux * gather_lobe(pass, point, photon.w) *
               left_in_cylinder(pass, point, photon);
    const SampledSpectrum light = photon.flux * correction(point, photon);
    return point.bsdf == kLambertian ? light : light * gather_lobe(pass, point, photon.w);
}

/// Returns the factor that all photons of a kind share at a point.
/// @param radius  of its gather disc for them.
/// @param paths  N.
inline SampledSpectrum share_of(const VisiblePoint& point, PhotonKind kind, float radius,
                                std::uint32_t paths) {
    float surface = kPi * radius * radius;
    if (point.disc.is_probed_for(kind))
        surface /= kind == PhotonKind::indirect ? point.indirect_disc_over_surface
                                                : point.disc_over_surface;
    const float share = kind == PhotonKind::direct ? point.photon_share : 1;
    return point.throughput * (share / (static_cast<float>(paths) * surface));
}

/// Returns the AOV of the light that a photon of this kind brings to this point.
inline Aov owner_of(const VisiblePoint& point, PhotonKind kind) {
    if (point.after_rough || kind == PhotonKind::indirect) return Aov::indirect;
    return kind == PhotonKind::direct ? Aov::direct : Aov::caustic;
}

}  // namespace sunfleck::engine
