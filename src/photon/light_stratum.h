// LightStratum: lights whose photon paths are sampled together; the light of all strata adds up.
#pragma once

#include "aovs/transport.h"
#include "chains/splitting.h"
#include "scene/pass_scene.h"
#include "visible_points/visible_point_index.h"
#include "visible_points/visible_point_octree.h"

#include <vector>

namespace sunfleck::engine {

/// The scene and the visible points of a pass, for its photons.
struct PhotonContext {
    const PassScene& scene;
    const TransportSettings& transport;
    const VisiblePointIndex& index;
};

/// Returns the octree over the visible points.
inline VisiblePointOctree octree_of(const PhotonContext& photon_context) {
    const SceneSphere& sphere = photon_context.scene.scene.sphere();
    return {photon_context.index.points(), sphere.center, sphere.radius};
}

/// Some of the lights, with the plan of their paths. Fixed for an epoch.
struct LightStratum {
    LightChoice lights;        // in which paths start
    SplittingPlan plan;        // without levels: uniform paths only, or guided ones only
    GuidedPlan guided;         // guided paths beside it, or before its one level
    double power_share = 1;    // fraction of the power of all lights
    std::uint32_t number = 0;  // names the random numbers: see PassId

    /// Returns whether a guide of full support starts all paths; chains may bring what bounded
    /// weights leave.
    bool has_full_guide() const { return plan.uniform_paths == 0 && guided.paths > 0; }
    std::uint64_t paths() const { return plan.paths() + guided.paths; }
};

/// Returns the paths of all strata.
inline std::uint64_t paths_of(const std::vector<LightStratum>& strata) {
    std::uint64_t paths = 0;
    for (const LightStratum& stratum : strata) paths += stratum.paths();
    return paths;
}

/// Counts of a stratum in one pass.
struct StratumCounts {
    std::uint64_t paths = 0;  // planned
    double power_share = 1;
    double visible_fraction = 0;  // of uniform paths from its lights, estimated
    SplittingCounts splitting;    // of a plan with levels
};

}  // namespace sunfleck::engine
