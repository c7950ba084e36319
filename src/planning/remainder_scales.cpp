// Chains of a pilot, started where trials were visible.
#include "planning/remainder_scales.h"

#include "chains/learned_guide.h"
#include "photon/photon_space.h"

namespace sunfleck::engine {
namespace {

/// Of the other dimensions of a start, which are drawn anew.
constexpr GuideSampleBudget kTries{1024, 16};

}  // namespace

MutationScales remainder_scales(const PhotonContext& context, const LightChoice& lights,
                                const GuidedPlan& guided,
                                const std::vector<WeightedEmission>& starts,
                                const PilotName& name) {
    const PhotonTracer tracer(context.scene, context.transport, lights);
    const VisiblePointOctree octree = octree_of(context);
    const PhotonSpace space(tracer, context.index, octree);
    ChainWalk<PhotonSpace> walk(space, name, &guided);
    Statistics unused;
    Population population = visible_from(space, starts, walk.next_iteration(), unused, kTries);
    MutationScales scales;
    if (population.units() > 0)
        walk.until_settled(kVisible, kTargetAcceptance, scales, population, unused);
    return scales;
}

}  // namespace sunfleck::engine
