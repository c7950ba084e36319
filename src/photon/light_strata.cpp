// Pilots: a short one a light, then a ladder's a group.
#include "photon/light_strata.h"

#include "photon/edge_search.h"
#include "photon/importons.h"
#include "photon/photon_space.h"
#include "photon/stratum_rules.h"
#include "random_numbers/emission_points.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace sunfleck {
namespace {

constexpr std::size_t kMostClusters = 64;
constexpr std::uint32_t kMeasuring = 1;  // part of the pilots' numbers that measure clusters

/// What a walk from the view costs at most, in paths of a picture: it meets many surfaces, and asks
/// for a light at each. Measured: 7 in the dark, where photon paths cost least; 1 to 2 in lit
/// rooms.
constexpr std::uint64_t kPathsOfAWalk = 8;

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
    /// @param work  see LightPlanner.
    Lighting(const PhotonView& view, const PhotonSettings& settings, const PilotName& name,
             std::uint64_t work)
        : view_(view), settings_(settings), name_(name), work_(work), octree_(octree_of(view)) {}

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

    const PhotonView& view() const { return view_; }
    const PilotName& name() const { return name_; }
    const ViewOctree& octree() const { return octree_; }
    const LightChoice& weights() const { return view_.scene.scene.light_choice(); }

    Sets sets() const { return settings_.ladder ? Sets::as_needed : Sets::one; }

    /// @param ground  must outlive what is returned. @param groups  of lights: each is searched
    /// for.
    MapSource maps(const Ground& ground, std::size_t groups) const {
        if (!settings_.emission_maps || !settings_.light_search || view_.index.points().empty() ||
            ground.lights.empty())
            return {settings_.emission_maps};
        return {true,
                [this, &ground](PassId pass, const PathRange& walks) {
                    return walk_from_view(view_, ground.lights, pass, walks);
                },
                [this, &ground](PassId pass, const PathRange& tries) {
                    return emission_past_edges(view_, ground.lights, pass, tries);
                },
                [this](PassId pass) { return flux_seen(view_, pass); },
                static_cast<std::size_t>(work_ / (kPathsOfAWalk * groups))};
    }

private:
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
    std::uint64_t work_;
    ViewOctree octree_;
};

/// Lights by group, each explored by a pilot of its own.
class Pilots {
public:
    Pilots(const Lighting& lighting, std::vector<LightChoice> groups)
        : power_(lighting.weights().total()) {
        for (LightChoice& lights : groups) {
            grounds_.push_back(
                std::make_unique<Ground>(lighting.view(), lighting.octree(), std::move(lights)));
            const Ground& ground = *grounds_.back();
            pilots_.emplace_back(ground.space, lighting.name(),
                                 lighting.maps(ground, groups.size()), lighting.sets());
            const HeightTail& tail = pilots_.back().explore();
            fluxes_.push_back({ground.lights.total(), tail[kVisible], is_rare(tail)});
        }
    }

    std::vector<PhotonGroup> plan(std::uint32_t paths) {
        const std::vector<std::uint32_t> shares = shared_paths(fluxes_, paths);
        std::vector<PhotonGroup> groups;
        for (std::size_t g = 0; g < pilots_.size(); ++g) {
            PilotResult learned = pilots_[g].plan(shares[g]);
            groups.push_back({grounds_[g]->lights, std::move(learned.plan),
                              std::move(learned.mapped), power_ > 0 ? fluxes_[g].power / power_ : 1,
                              static_cast<std::uint32_t>(g)});
        }
        return groups;
    }

private:
    double power_;  // of all lights
    std::vector<std::unique_ptr<Ground>> grounds_;
    std::vector<GroundPilot> pilots_;
    std::vector<GroupFlux> fluxes_;
};

}  // namespace

/// Pilots are sent out when a plan asks for them.
struct LightPlanner::Learned {
    Lighting lighting;
    std::vector<Lights> groups;
    std::optional<Pilots> together;
    std::optional<Pilots> apart;

    explicit Learned(Lighting all) : lighting(std::move(all)) {}
};

LightPlanner::LightPlanner(const PhotonView& view, const PhotonSettings& settings,
                           const PilotName& name, std::uint64_t work)
    : learned_(std::make_unique<Learned>(Lighting(view, settings, name, work))) {
    if (settings.light_groups) learned_->groups = learned_->lighting.groups();
}

LightPlanner::~LightPlanner() = default;

std::vector<PhotonGroup> LightPlanner::plan(std::uint32_t paths) {
    Learned& l = *learned_;
    const LightChoice& all = l.lighting.weights();
    if (l.groups.size() < 2 || paths < 2 * l.groups.size()) {
        if (!l.together) l.together.emplace(l.lighting, std::vector{all});
        return l.together->plan(paths);
    }
    if (!l.apart) {
        std::vector<LightChoice> choices;
        for (const Lights& lights : l.groups) choices.push_back(all.among(lights));
        l.apart.emplace(l.lighting, std::move(choices));
    }
    return l.apart->plan(paths);
}

}  // namespace sunfleck
