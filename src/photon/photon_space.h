// Photon paths as a space that Markov chains walk in: a path is what can be seen of it.
//
// In:  primary samples. Out: the photons of a path that a disc may take, and its height: how near
// to the view any of its photons came, or that one of them is taken.
#pragma once

#include "measurement/view_octree.h"
#include "measurement/visible_point_index.h"
#include "photon/tracer.h"
#include "sampler/path_space.h"

#include <algorithm>
#include <vector>

namespace sunfleck {

/// What a photon path leaves behind. Photons that no disc can reach are not kept.
struct PhotonPath {
    std::vector<Photon> photons;
    int near = 0;  // greatest height of any photon's place in the octree
};

class PhotonSpace {
public:
    using Path = PhotonPath;
    using Tally = Statistics;
    static_assert(ViewOctree::kFull < kVisible);

    PhotonSpace(const PhotonTracer& tracer, const VisiblePointIndex& index,
                const ViewOctree& octree)
        : tracer_(tracer), index_(index), octree_(octree), kinds_(kinds_taken(index)) {}

    template <SlotReader Reader>
    void trace(Reader&& read, PhotonPath& path, Statistics& counts) const {
        path.photons.clear();
        path.near = 0;
        const auto visit = [&](const Photon& photon) {
            if ((kinds_ & static_cast<std::uint8_t>(photon.kind)) == 0) return true;
            const int height = octree_.height(photon.position);
            path.near = std::max(path.near, height);
            if (height == ViewOctree::kFull) path.photons.push_back(photon);
            return true;
        };
        const PathEnd end = tracer_.trace(read, visit, counts[Count::photon_rays]);
        counts[Count::escaped] += end == PathEnd::escaped ? 1 : 0;
        counts[Count::too_long] += end == PathEnd::too_long ? 1 : 0;
    }

    int height(const PhotonPath& path) const {
        const auto taken = [&](const Photon& photon) { return index_.any(photon); };
        const bool visible = std::any_of(path.photons.begin(), path.photons.end(), taken);
        return visible ? kVisible : path.near;
    }

private:
    /// The kinds of photons that some disc takes.
    static std::uint8_t kinds_taken(const VisiblePointIndex& index) {
        std::uint8_t kinds = 0;
        for (const VisiblePoint& point : index.points()) kinds |= point.disc.kinds;
        return kinds;
    }

    const PhotonTracer& tracer_;
    const VisiblePointIndex& index_;
    const ViewOctree& octree_;
    std::uint8_t kinds_;
};

static_assert(PathSpace<PhotonSpace>);

}  // namespace sunfleck
