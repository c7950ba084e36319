// Lights in groups: each group's photon paths are sampled by themselves, and all add up.
#pragma once

#include "aovs/transport.h"
#include "chains/splitting.h"
#include "scene/pass_scene.h"
#include "visible_points/visible_point_index.h"
#include "visible_points/visible_point_octree.h"

#include <vector>

namespace sunfleck {

/// What photons of a pass go through and towards.
struct PhotonView {
    const PassScene& scene;
    const TransportSettings& transport;
    const VisiblePointIndex& index;
};

/// The octree over what is seen.
inline ViewOctree octree_of(const PhotonView& view) {
    const SceneSphere& sphere = view.scene.scene.sphere();
    return {view.index.points(), sphere.center, sphere.radius};
}

/// Some of the lights, and how paths from them are sampled. Fixed for an epoch.
struct PhotonGroup {
    LightChoice lights;      // where its paths start
    LadderPlan plan;         // without levels: uniform paths alone
    MappedPlan mapped;       // uniform paths besides
    double power_share = 1;  // of all lights' power
    std::uint32_t part = 0;  // names its random numbers: see PassId

    std::uint64_t paths() const { return plan.paths() + mapped.paths; }
};

/// Of all groups.
inline std::uint64_t paths_of(const std::vector<PhotonGroup>& groups) {
    std::uint64_t paths = 0;
    for (const PhotonGroup& group : groups) paths += group.paths();
    return paths;
}

/// What a group's paths brought to one pass.
struct GroupCounts {
    std::uint64_t paths = 0;  // planned
    double power_share = 1;
    double visible_fraction = 0;  // of uniform paths from its lights, estimated
    LadderCounts ladder;          // of a plan with levels

    /// Another draw of the same pass, with its share in the mean over draws.
    void add(const GroupCounts& draw, double share) {
        paths += draw.paths;
        power_share = draw.power_share;
        visible_fraction += draw.visible_fraction * share;
        ladder.add(draw.ladder, share);
    }
};

}  // namespace sunfleck
