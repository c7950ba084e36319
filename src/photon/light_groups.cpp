// Pilots: a short one a light, then a ladder's a group.
#include "photon/light_groups.h"

#include "photon/group_rules.h"
#include "photon/photon_space.h"
#include "photon/view_walks.h"
#include "sampler/emission_points.h"

#include <algorithm>
#include <memory>

namespace sunfleck {
namespace {

constexpr std::size_t kMostClusters = 64;
constexpr std::uint32_t kMeasuring = 1;  // part of the pilots' numbers that measure clusters

using Lights = std::vector<std::uint32_t>;

/// The paths of some lights, and what is seen of them.
struct Ground {
    LightChoice lights;
    PhotonTracer tracer;
    PhotonSpace space;

    Ground(const PhotonView& view, const ViewOctree& octree, LightChoice some)
        : lights(std::move(some)),
          tracer(view.scene, view.transport, lights),
          space(tracer, view.index, octree) {}
    Ground(const Ground&) = delete;
    Ground(Ground&&) = delete;
    Ground& operator=(const Ground&) = delete;
    Ground& operator=(Ground&&) = delete;
    ~Ground() = default;
};

using GroundPilot = Pilot<PhotonSpace, EmissionPoints>;

/// The view, and all lights.
class Lighting {
public:
    Lighting(const PhotonView& view, const PhotonSettings& settings, const PilotName& name)
        : view_(view), settings_(settings), name_(name), octree_(octree_of(view)) {}

    PhotonGroup all(std::uint32_t paths) const {
        Ground ground(view_, octree_, weights());
        PilotResult learned = GroundPilot(ground.space, name_, maps(ground)).run(paths);
        return {std::move(ground.lights), std::move(learned.plan), std::move(learned.mapped), 1, 0};
    }

    /// Lights by group.
    std::vector<Lights> groups() const {
        std::vector<Lights> clusters =
            light_clusters(view_.scene.scene.light_sources(), weights(), kMostClusters);
        if (clusters.size() < 2) return clusters;
        std::vector<Lights> groups;
        for (const std::vector<std::size_t>& group : grouped(measured(clusters))) {
            Lights& lights = groups.emplace_back();
            for (const std::size_t c : group)
                lights.insert(lights.end(), clusters[c].begin(), clusters[c].end());
        }
        return groups;
    }

    /// A ladder for each.
    std::vector<PhotonGroup> planned(const std::vector<Lights>& groups, std::uint32_t paths) const {
        std::vector<std::unique_ptr<Ground>> grounds;
        std::vector<GroundPilot> pilots;
        std::vector<GroupFlux> fluxes;
        for (const Lights& lights : groups) {
            grounds.push_back(std::make_unique<Ground>(view_, octree_, weights().among(lights)));
            pilots.emplace_back(grounds.back()->space, name_, maps(*grounds.back()));
            const HeightTail& tail = pilots.back().explore();
            fluxes.push_back({grounds.back()->lights.total(), tail[kVisible], is_rare(tail)});
        }
        const std::vector<std::uint32_t> shares = shared_paths(fluxes, paths);
        std::vector<PhotonGroup> result;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            PilotResult learned = pilots[g].plan(shares[g]);
            result.push_back({grounds[g]->lights, std::move(learned.plan),
                              std::move(learned.mapped), fluxes[g].power / weights().total(),
                              static_cast<std::uint32_t>(g)});
        }
        return result;
    }

private:
    const LightChoice& weights() const { return view_.scene.scene.light_choice(); }

    /// @param ground  must outlive what is returned.
    MapSource maps(const Ground& ground) const {
        if (!settings_.emission_maps || view_.index.points().empty() || ground.lights.empty())
            return {settings_.emission_maps};
        return {true,
                [this, &ground](PassId pass, const PathRange& walks) {
                    return walk_from_view(view_, ground.lights, pass, walks);
                },
                [this](PassId pass) { return flux_seen(view_, pass); }};
    }

    /// A few paths of each cluster; more where these are too few to tell fractions apart.
    std::vector<MeasuredLight> measured(const std::vector<Lights>& clusters) const {
        constexpr std::size_t kLeast = 1000;
        constexpr std::size_t kMost = 4000;
        constexpr std::size_t kOfAll = 64'000;
        constexpr std::size_t kOfAllAtMost = 128'000;
        constexpr std::uint64_t kEnough = 2 * kFractionsApart;
        std::vector<MeasuredLight> lights =
            measured(clusters, std::clamp(kOfAll / clusters.size(), kLeast, kMost), 0);
        const std::size_t more = kOfAllAtMost / clusters.size();
        const bool tells = std::any_of(lights.begin(), lights.end(),
                                       [](const MeasuredLight& l) { return l.visible >= kEnough; });
        if (tells || more < 2 * lights.front().paths) return lights;
        return measured(clusters, more, 1);
    }

    std::vector<MeasuredLight> measured(const std::vector<Lights>& clusters, std::size_t paths,
                                        std::uint32_t round) const {
        std::vector<MeasuredLight> lights;
        for (const Lights& cluster : clusters) {
            const Ground ground(view_, octree_, weights().among(cluster));
            const PilotName name{name_.seed, name_.epoch, kMeasuring};
            Statistics unused;
            const LevelCounts counts =
                uniform_level(ground.space, EmissionPoints(name.round(round)),
                              static_cast<std::uint32_t>(paths), kHeights, unused)
                    .counts;
            lights.push_back({ground.lights.total(), paths, counts.at_least(kVisible)});
        }
        return lights;
    }

    const PhotonView& view_;
    const PhotonSettings& settings_;
    PilotName name_;
    ViewOctree octree_;
};

}  // namespace

PhotonGroup learn_one_group(const PhotonView& view, const PhotonSettings& settings,
                            const PilotName& name, std::uint32_t paths) {
    return Lighting(view, settings, name).all(paths);
}

std::vector<PhotonGroup> learn_light_groups(const PhotonView& view, const PhotonSettings& settings,
                                            const PilotName& name, std::uint32_t paths) {
    const Lighting lighting(view, settings, name);
    const std::vector<Lights> groups = lighting.groups();
    if (groups.size() < 2 || paths < 2 * groups.size()) return {lighting.all(paths)};
    return lighting.planned(groups, paths);
}

}  // namespace sunfleck
