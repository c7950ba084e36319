// PhotonSpace: photon paths as a path space for Markov chains.
//
// In:  primary samples. Out: the photons of a path that a gather disc may accept, and its height:
// how near any of its photons came to the visible points, or that one is accepted.
#pragma once

#include "chains/path_space.h"
#include "photon/tracer.h"
#include "visible_points/visible_point_index.h"
#include "visible_points/visible_point_octree.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {

/// The data kept of a photon path. Photons that no disc can accept are not kept.
struct PhotonPath {
    std::vector<Photon> photons;
    int near = 0;  // greatest height of a photon in the octree
};

class PhotonSpace {
public:
    using Path = PhotonPath;
    using Tally = Statistics;
    static_assert(VisiblePointOctree::kFull < kVisible);

    PhotonSpace(const PhotonTracer& tracer, const VisiblePointIndex& index,
                const VisiblePointOctree& octree)
        : tracer_(tracer), index_(index), octree_(octree) {}

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, PhotonPath& path, Statistics& counts) const {
        path.photons.clear();
        path.near = 0;
        const auto visit = [&](const Photon& photon) { add(photon, path); };
        count_end(tracer_.trace(read, visit, counts[Count::photon_rays]), counts);
    }

    /// Adds the next photon of a path.
    void add(const Photon& photon, PhotonPath& path) const {
        if (!index_.accepts_kind(photon)) return;
        const int height = octree_.height(photon.position);
        path.near = std::max(path.near, height);
        if (height == VisiblePointOctree::kFull) path.photons.push_back(photon);
    }

    int height(const PhotonPath& path) const {
        return index_.any(path.photons) ? kVisible : path.near;
    }

private:
    const PhotonTracer& tracer_;
    const VisiblePointIndex& index_;
    const VisiblePointOctree& octree_;
};

static_assert(PathSpace<PhotonSpace>);

}  // namespace sunfleck::engine
