// Visible points: where camera paths end to gather photons; and the photons that they gather.
//
// A disc says where and what a visible point accepts; photons that it accepts are deposited. One
// function, accepts(), decides it for the visibility query and for the deposit alike.
#pragma once

#include "aovs/light_groups.h"
#include "bsdf/bsdf.h"
#include "math/sampled_spectrum.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// How a photon reached the surface that it meets: exactly one.
enum class PhotonKind : std::uint8_t {
    direct = 1,              // straight from the light
    caustic = 2,             // scattered by smooth (specular) surfaces alone, at least once
    indirect = 4,            // scattered by a rough surface at least once
    long_specular_chain = 8  // scattered by smooth surfaces alone, kLongSpecularChain times or more
};

/// Light that so many smooth surfaces have passed on came by a way of its own that few photons find
/// and that spreads them far: it bears more blur. Through a full glass behind a pane there are six
/// (docs/develop/decisions.md, long specular chains).
inline constexpr std::uint16_t kLongSpecularChain = 7;

/// A photon at a surface that can gather; or several alike, as states of a chain bring them.
struct Photon {
    Vec3 position{0};
    Vec3 normal{0};             // geometric, on the side that the photon arrives at
    Vec3 w{0};                  // unit, back along the photon
    std::uint16_t bounces = 0;  // scattering events so far
    PhotonKind kind = PhotonKind::direct;
    std::uint8_t light_group = kNoLightGroup;  // of the light that it comes from
    std::uint32_t copies = 1;                  // so many alike
    SampledSpectrum flux;                      // of all copies
};

/// A disc's radius for photons of a kind. @param sharp  that for direct photons and caustics.
/// @param indirect  that for indirect ones.
inline float radius_of_kind(PhotonKind kind, float sharp, float indirect) {
    if (kind == PhotonKind::indirect) return indirect;
    return kind == PhotonKind::long_specular_chain ? (indirect + indirect) - sharp : sharp;
}

/// The part of a visible point that decides which photons it accepts. 36 bytes.
struct Disc {
    Vec3 position{0};
    float radius = 0;           // for direct photons and caustics
    Vec3 normal{0};             // geometric, on the side that the camera path arrived at
    std::uint16_t bounces = 0;  // scattering events of the camera path before this point
    std::uint8_t kinds = 0;     // sum of the PhotonKinds that it accepts
    bool both_sides = false;    // transmits: accepts photons from behind, too
    float indirect_radius_scale =
        1;  // of the disc for indirect photons, over the radius; 1 or more

    /// For photons of this kind. Light that a rough surface has scattered has few edges: a wider
    /// disc has less noise and hardly more bias. long specular chains have one that is wider by
    /// twice as much.
    float radius_for(PhotonKind kind) const {
        return radius_of_kind(kind, radius, radius * indirect_radius_scale);
    }
    bool accepts_kind(PhotonKind kind) const {
        return (kinds & static_cast<std::uint8_t>(kind)) != 0;
    }
    /// The widest of the kinds that it accepts, but for long specular chains.
    float usual_radius() const {
        return accepts_kind(PhotonKind::indirect) ? radius_for(PhotonKind::indirect) : radius;
    }
    /// Of all kinds that it accepts.
    float widest_radius() const {
        const bool deep = accepts_kind(PhotonKind::long_specular_chain);
        return deep ? radius_for(PhotonKind::long_specular_chain) : usual_radius();
    }
};

/// Normals further apart than 60 degrees do not agree.
inline constexpr float kNormalAgreement = 0.5F;
/// Half height of the disc over its radius. Distance is measured along the mean of both normals,
/// which vanishes between points of any sphere: smooth rims lose nothing, thin walls do not leak.
inline constexpr float kDiscFlatness = 0.25F;

/// Does the disc take this photon?
/// @param max_depth  scattering events of the whole path, at most.
inline bool accepts(const Disc& disc, const Photon& photon, int max_depth) {
    const Vec3 d = photon.position - disc.position;
    const float radius = disc.radius_for(photon.kind);
    const float radius2 = radius * radius;
    const float distance2 = d.length2();
    if (!(distance2 < 1.5F * radius2)) return false;  // a quick no: what follows is narrower
    if (!disc.accepts_kind(photon.kind)) return false;
    if (disc.bounces + photon.bounces >= max_depth) return false;
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

/// A disc and what a photon there is worth to its pixel.
struct VisiblePoint {
    Disc disc;
    Vec3 shading_normal{0};
    Vec3 tangent{0};
    Vec3 wo{0};                  // world, unit, back towards the camera
    SampledSpectrum throughput;  // of the camera path, with the filter's weight; for a Lambertian
                                 // surface times albedo / pi
    std::uint32_t pixel = 0;
    std::uint32_t bsdf = 0;  // PassScene::kept() has what gathers; kLambertian: none needed
    std::uint8_t hero = 0;   // a path that has dispersed: its wavelength
    bool single_wavelength = false;
    bool after_rough = false;  // the camera path has been scattered by a rough surface before
    bool shares_pixel = true;  // there may be other points of the same pixel (set by the index)

    /// Is there no shading normal other than the surface's own?
    bool is_flat() const { return shading_normal == disc.normal || shading_normal == -disc.normal; }
};

inline constexpr std::uint32_t kLambertian = 0xFFFFFFFF;

/// Visible points as they are found: a list for each block of pixels.
using VisiblePointLists = std::vector<std::vector<VisiblePoint>>;

}  // namespace sunfleck::engine
