// Photons and visible points become pixel values: the density estimate of one pass.
//
// In:  photons, an index of visible points. Out: the sums of photon_terms.h in the pass's image.
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
    /// @param paths   photon paths of the pass: N of the estimate.
    /// @param counts  one of each pixel, to be added to; or none.
    Depositor(const PassScene& pass, const VisiblePointIndex& index, PassImage& image,
              std::uint32_t paths, PhotonCounts* counts = nullptr)
        : pass_(pass), index_(index), image_(image), paths_(paths), counts_(counts) {}

    /// Adds to every visible point the photons that it accepts, and marks in the chunks which were
    /// taken. Each point sums in floats, in an order that depends on the chunks alone (not on the
    /// threads), and adds one term a kind of photon to the exact sums of its pixel. The flux of a
    /// photon is taken as it is: whoever weights paths scales it before. @return counts.
    Statistics operator()(std::vector<PhotonChunk>& chunks) const;

private:
    const PassScene& pass_;
    const VisiblePointIndex& index_;
    PassImage& image_;
    std::uint32_t paths_;
    PhotonCounts* counts_;
};

}  // namespace sunfleck::engine
