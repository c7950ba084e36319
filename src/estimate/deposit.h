// Depositor: the radiance estimate of one pass, from photons and visible points to pixel values.
//
// In:  photons, an index of visible points. Out: the sums of photon_terms.h in the image of the
// pass.
// Equations: docs/method/method.md, eq. (2).
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "estimate/photon_counts.h"
#include "scene/pass_scene.h"
#include "visible_points/photon_chunk.h"
#include "visible_points/visible_point_index.h"

namespace sunfleck::engine {

class Depositor {
public:
    /// @param paths   number of photon paths of the pass: N of the estimate.
    /// @param counts  photon counts per pixel, to be added to; or null.
    Depositor(const PassScene& pass, const VisiblePointIndex& index, PassImage& image,
              std::uint32_t paths, PhotonCounts* counts = nullptr)
        : pass_(pass), index_(index), image_(image), paths_(paths), counts_(counts) {}

    /// Adds to every visible point the photons that it accepts, and marks accepted photons in their
    /// chunks. Each point sums in floats, in an order that depends on the chunks alone (not on the
    /// threads), and adds one term per kind of photon to the exact sums of its pixel. The flux of a
    /// photon is used as it is; the caller includes path weights.
    /// @return statistics of the deposit.
    Statistics operator()(std::vector<PhotonChunk>& chunks) const;

private:
    const PassScene& pass_;
    const VisiblePointIndex& index_;
    PassImage& image_;
    std::uint32_t paths_;
    PhotonCounts* counts_;
};

}  // namespace sunfleck::engine
