// Visible points and photons: where camera paths gather, and what they gather (Hachisuka et al.
// 2008).
//
// The kernel of a visible point says which photons it accepts: a disc on a surface, in a medium a
// cylinder around a piece of the camera's ray. The function accepts() is the gather test, for the
// visibility query and for the deposit alike.
// Equations: docs/method/method.md, eqs. (4) and (7).
#pragma once

#include "aovs/light_groups.h"
#include "bsdf/bsdf.h"
#include "math/sampled_spectrum.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// How a photon reached the surface of its hit, or its place in a medium; exactly one applies.
enum class PhotonKind : std::uint8_t {
    direct = 1,              // straight from the light
    caustic = 2,             // by specular surfaces alone, at least one
    indirect = 4,            // by at least one rough surface, or a medium
    long_specular_chain = 8  // by specular surfaces alone, kLongSpecularChain or more
};

/// From this many specular events on, light arrives by paths that few photons find and that spread
/// them far, so it tolerates a larger gather radius. A full glass behind a pane has six events
/// (docs/develop/decisions.md, long specular chains).
inline constexpr std::uint16_t kLongSpecularChain = 7;

// Sets of kinds.
inline constexpr std::uint8_t kCausticKinds =
    static_cast<std::uint8_t>(PhotonKind::caustic) |
    static_cast<std::uint8_t>(PhotonKind::long_specular_chain);
inline constexpr std::uint8_t kScatteredKinds =
    kCausticKinds | static_cast<std::uint8_t>(PhotonKind::indirect);
inline constexpr std::uint8_t kAllKinds =
    kScatteredKinds | static_cast<std::uint8_t>(PhotonKind::direct);

/// Photons in media have the same kinds, this many bits further on in a set of kinds.
inline constexpr unsigned kKindsInMedia = 4;

/// A photon at a surface that gathers, or where a medium scatters it; or several identical ones
/// from repeated states of a chain.
struct Photon {
    Vec3 position{0};
    Vec3 normal{0};             // geometric, on the side of arrival; zero in a medium
    Vec3 w{0};                  // unit, back along the photon
    std::uint16_t bounces = 0;  // scattering events so far
    PhotonKind kind = PhotonKind::direct;
    std::uint8_t light_group = kNoLightGroup;  // group of its light
    bool in_medium = false;
    std::uint32_t copies = 1;  // number of identical photons
    SampledSpectrum flux;      // of all copies

    /// Returns its kind as a set, see Disc::kinds.
    std::uint8_t kinds() const {
        const auto bit = static_cast<unsigned>(kind);
        return static_cast<std::uint8_t>(in_medium ? bit << kKindsInMedia : bit);
    }
};

/// Returns the gather radius for photons of a kind.
/// @param sharp  radius for direct and caustic photons.
/// @param indirect  radius for indirect photons.
inline float radius_of_kind(PhotonKind kind, float sharp, float indirect) {
    if (kind == PhotonKind::indirect) return indirect;
    return kind == PhotonKind::long_specular_chain ? (indirect + indirect) - sharp : sharp;
}

/// The kernel: the part of a visible point that decides which photons it accepts, a disc or a
/// cylinder. 40 bytes.
struct Disc {
    Vec3 position{0};
    float radius = 0;           // for direct and caustic photons
    Vec3 normal{0};             // geometric, on the side of the camera path; axis of a cylinder
    std::uint16_t bounces = 0;  // scattering events of the camera path before this point
    std::uint8_t kinds = 0;     // sum of the PhotonKinds that it accepts, on surfaces or in media
    bool both_sides = false;    // accepts photons from behind (transmission), too
    float indirect_radius_scale = 1;  // radius scale of indirect photons, at least 1
    float half_length = 0;            // of a cylinder

    /// Returns whether it is a cylinder.
    bool is_in_medium() const { return (kinds >> kKindsInMedia) != 0; }

    /// Returns the radius for a kind of photons. Light from rough surfaces has few edges, so a
    /// wider disc has less noise and hardly more bias. Long specular chains have a disc that is
    /// wider by twice as much.
    float radius_for(PhotonKind kind) const {
        return radius_of_kind(kind, radius, radius * indirect_radius_scale);
    }
    bool accepts_kind(PhotonKind kind) const {
        const unsigned any = kinds | static_cast<unsigned>(kinds) >> kKindsInMedia;
        return (any & static_cast<unsigned>(kind)) != 0;
    }
    /// Returns whether the kernel is probed for edges for this kind. A disc for caustics alone is
    /// as wide as a pixel or two, and loses little, as do cylinders for light that is not indirect.
    bool is_probed_for(PhotonKind kind) const {
        if (kind == PhotonKind::indirect) return accepts_kind(kind);
        if (kind == PhotonKind::long_specular_chain || is_in_medium()) return false;
        return accepts_kind(PhotonKind::direct);
    }
    /// Returns the largest radius of the accepted kinds, long specular chains aside.
    float usual_radius() const {
        return accepts_kind(PhotonKind::indirect) ? radius_for(PhotonKind::indirect) : radius;
    }
    /// Returns the largest radius of all accepted kinds.
    float widest_radius() const {
        const bool deep = accepts_kind(PhotonKind::long_specular_chain);
        return deep ? radius_for(PhotonKind::long_specular_chain) : usual_radius();
    }
};

/// Normals that differ by more than 60 degrees do not agree.
inline constexpr float kNormalAgreement = 0.5F;
/// Half height of the disc over its radius. Distance is measured along the mean of both normals,
/// which vanishes between points of a sphere: smooth rims lose nothing, and thin walls do not leak.
inline constexpr float kDiscFlatness = 0.25F;

/// Returns whether a photon lies in a disc: accepts(), but for kind and depth.
inline bool is_in_disc(const Disc& disc, const Photon& photon) {
    const Vec3 d = photon.position - disc.position;
    const float radius = disc.radius_for(photon.kind);
    const float radius2 = radius * radius;
    const float distance2 = d.length2();
    if (!(distance2 < 1.5F * radius2)) return false;  // fast rejection: what follows is stricter
    float agreement = disc.normal.dot(photon.normal);
    Vec3 other = photon.normal;
    if (agreement < 0) {
        if (!disc.both_sides) return false;
        agreement = -agreement;
        other = -other;
    }
    if (agreement < kNormalAgreement) return false;
    const float along = d.dot(disc.normal + other) * 0.5F;
    if (std::abs(along) > kDiscFlatness * radius) return false;
    const float above = d.dot(disc.normal);
    return distance2 - above * above < radius2;
}

/// Returns whether a photon of a medium lies in a cylinder: accepts(), but for kind and depth.
inline bool is_in_cylinder(const Disc& cylinder, const Photon& photon) {
    const Vec3 d = photon.position - cylinder.position;
    const float radius = cylinder.radius_for(photon.kind);
    const float above = d.dot(cylinder.normal);
    if (!(std::abs(above) < cylinder.half_length)) return false;
    return d.length2() - above * above < radius * radius;
}

/// Returns whether a kernel accepts a photon (the gather test).
/// @param max_depth  largest number of scattering events of the whole path.
inline bool accepts(const Disc& disc, const Photon& photon, int max_depth) {
    if ((disc.kinds & photon.kinds()) == 0) return false;
    if (disc.bounces + photon.bounces >= max_depth) return false;
    return photon.in_medium ? is_in_cylinder(disc, photon) : is_in_disc(disc, photon);
}

/// A kernel, and the weight of its photons in the pixel.
struct VisiblePoint {
    Disc disc;
    Vec3 shading_normal{0};
    Vec3 tangent{0};
    Vec3 wo{0};                   // world, unit, towards the camera
    SampledSpectrum throughput;   // of the camera path, with the filter's weight; for a Lambertian
                                  // surface times albedo / pi
    float disc_over_surface = 1;  // an estimate, for direct and caustic photons; of a cylinder its
                                  // volume over that of the medium in it
    float indirect_disc_over_surface = 1;  // the same for indirect ones
    float photon_share = 1;  // of a cylinder: what photons bring of the light straight from lights
    std::uint32_t pixel = 0;
    std::uint32_t bsdf = 0;    // for PassScene::kept(); kLambertian needs none
    std::uint32_t medium = 0;  // of a cylinder
    std::uint8_t hero = 0;  // hero wavelength of a path whose secondary wavelengths are terminated
    bool single_wavelength = false;
    bool after_rough = false;  // a rough surface scattered the camera path before
    bool shares_pixel = true;  // the pixel may have other points (set by the index)
    bool needs_sight = false;  // photons that something hides from it do not count

    /// Returns whether the shading normal equals the geometric one, on either side.
    bool is_flat() const { return shading_normal == disc.normal || shading_normal == -disc.normal; }
};

inline constexpr std::uint32_t kLambertian = 0xFFFFFFFF;

/// Visible points in the order of their creation: a list per block of pixels.
using VisiblePointLists = std::vector<std::vector<VisiblePoint>>;

}  // namespace sunfleck::engine
