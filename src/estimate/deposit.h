// Photons and visible points become pixel values: the density estimate of one pass.
//
// L = 1 / (N pi r^2) sum over photons of throughput * f(w, w_from) * flux * |n_s.w| / |n_g.w|.
// Source: paper section 3.1 (progressive density estimation); Hachisuka and Jensen 2009, eq. 8,
// with one radius a pass; shading normals: photon density measures |n_g.w|, a bsdf |n_s.w|.
#pragma once

#include "measurement/pass_image.h"
#include "measurement/photon_batch.h"
#include "measurement/statistics.h"
#include "measurement/visible_point_index.h"
#include "scene/pass_scene.h"

namespace sunfleck {

/// f of the visible point towards the camera for light that comes from the photon's side, without
/// the part that its throughput holds already.
inline Spectrum gather_lobe(const PassScene& pass, const VisiblePoint& point, const Vec3& w) {
    const Frame frame(point.shading_normal, point.tangent);
    const Bsdf& bsdf = *pass.bsdfs[point.material];
    const Vec3 from = frame.to_local(point.w_from);
    const Vec3 to = frame.to_local(w);
    if (point.single_lane && is_dispersive(bsdf))
        return eval(for_lane(bsdf, point.lane), from, to, Transport::radiance);
    return eval(bsdf, from, to, Transport::radiance);
}

/// The layer that owns what this photon brings to this point.
inline Layer owner_of(const VisiblePoint& point, const Photon& photon) {
    if (point.after_rough || photon.kind == PhotonKind::indirect) return Layer::indirect;
    return photon.kind == PhotonKind::direct ? Layer::direct : Layer::caustic;
}

class Depositor {
public:
    /// @param paths  photon paths of the pass: N of the estimate.
    Depositor(const PassScene& pass, const VisiblePointIndex& index, PassImage& image,
              std::uint32_t paths)
        : pass_(pass), index_(index), image_(image), per_path_(1 / static_cast<float>(paths)) {}

    /// Adds the photons to every visible point that takes them, in an order in which neighbours
    /// find their discs and pixels in the cache (sums are exact: any order gives the same bytes).
    /// Marks which photons were taken. @return counts of deposits.
    Statistics operator()(std::vector<PhotonBatch>& batches) const;

    /// The same for one photon. @return whether it was taken.
    bool deposit(const Photon& photon, Statistics& statistics) const {
        const bool taken = index_.for_each(photon, [&](const VisiblePoint& point) {
            ++statistics[Count::deposits];
            add(point, photon);
        });
        if (taken) ++statistics[Count::photons_stored];
        return taken;
    }

private:
    void add(const VisiblePoint& point, const Photon& photon) const {
        const Disc& disc = point.disc;
        const float corrected =
            std::abs(point.shading_normal.dot(photon.w)) / std::abs(disc.normal.dot(photon.w));
        const float kernel = corrected * per_path_ / (kPi * disc.radius * disc.radius);
        Spectrum value = point.throughput * photon.flux * kernel;
        if (point.material != kLambertian) value *= gather_lobe(pass_, point, photon.w);
        image_.add_light(point.pixel, pass_.wavelengths.to_rgb(value), owner_of(point, photon));
    }

    const PassScene& pass_;
    const VisiblePointIndex& index_;
    PassImage& image_;
    float per_path_;
};

}  // namespace sunfleck
