// Lights in strata: each stratum's photon paths are sampled by themselves, and all add up.
#pragma once

#include "aovs/transport.h"
#include "chains/splitting.h"
#include "scene/pass_scene.h"
#include "visible_points/visible_point_index.h"
#include "visible_points/visible_point_octree.h"

#include <vector>

namespace sunfleck::engine {

/// What photons of a pass go through and towards.
struct PhotonContext {
    const PassScene& scene;
    const TransportSettings& transport;
    const VisiblePointIndex& index;
};

/// The octree over what is seen.
inline VisiblePointOctree octree_of(const PhotonContext& view) {
    const SceneSphere& sphere = view.scene.scene.sphere();
    return {view.index.points(), sphere.center, sphere.radius};
}

/// Some of the lights, and how paths from them are sampled. Fixed for an epoch.
struct LightStratum {
    LightChoice lights;      // where its paths start
    SplittingPlan plan;      // without levels: uniform paths alone
    GuidedPlan guided;       // uniform paths besides
    double power_share = 1;  // of all lights' power
    std::uint32_t part = 0;  // names its random numbers: see PassId

    std::uint64_t paths() const { return plan.paths() + guided.paths; }
};

/// Of all strata.
inline std::uint64_t paths_of(const std::vector<LightStratum>& strata) {
    std::uint64_t paths = 0;
    for (const LightStratum& stratum : strata) paths += stratum.paths();
    return paths;
}

/// What a stratum's paths brought to one pass.
struct StratumCounts {
    std::uint64_t paths = 0;  // planned
    double power_share = 1;
    double visible_fraction = 0;  // of uniform paths from its lights, estimated
    SplittingCounts splitting;    // of a plan with levels

    /// Another subpass of the same pass, with its share in the mean over subpasses.
    void add(const StratumCounts& subpass, double share) {
        paths += subpass.paths;
        power_share = subpass.power_share;
        visible_fraction += subpass.visible_fraction * share;
        splitting.add(subpass.splitting, share);
    }
};

}  // namespace sunfleck::engine
