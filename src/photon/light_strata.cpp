// Pilots: a short one per light, then one per stratum.
#include "photon/light_strata.h"

#include "photon/edge_search.h"
#include "photon/importons.h"
#include "photon/photon_space.h"
#include "photon/strata_tuning.h"
#include "photon/stratum_rules.h"
#include "random_numbers/emission_points.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kMeasuring = 1;  // PassId::substream of the measurement of clusters

/// Upper bound of the cost of an importon in photon paths: it hits many surfaces, with a light
/// sample at each. Measured: 7 in the dark, where photon paths are cheapest; 1 to 2 in lit rooms.
constexpr std::uint64_t kPathsOfAWalk = 8;

using Lights = std::vector<std::uint32_t>;

/// The paths of some lights, with the visibility of their photons.
struct SamplingContext {
    LightChoice lights;
    PhotonTracer tracer;
    PhotonSpace space;

    SamplingContext(const PhotonContext& photon_context, const VisiblePointOctree& octree,
                    LightChoice some)
        : lights(std::move(some)),
          tracer(photon_context.scene, photon_context.transport, lights),
          space(tracer, photon_context.index, octree) {}
    SamplingContext(const SamplingContext&) = delete;
    SamplingContext(SamplingContext&&) = delete;
    SamplingContext& operator=(const SamplingContext&) = delete;
    SamplingContext& operator=(SamplingContext&&) = delete;
    ~SamplingContext() = default;
};

using PhotonPilot = Pilot<PhotonSpace, EmissionPoints>;

/// The visible points, and all lights.
class LightSurvey {
public:
    /// @param work  see LightPlanner.
    LightSurvey(const PhotonContext& photon_context, const PhotonSettings& settings,
                const PilotName& name, std::uint64_t work)
        : photon_context_(photon_context),
          settings_(settings),
          name_(name),
          work_(work),
          octree_(octree_of(photon_context)) {}

    /// Returns the lights by stratum.
    std::vector<Lights> strata() const {
        std::vector<Lights> clusters =
            light_clusters(photon_context_.scene.scene.light_sources(), weights(), kMostClusters);
        if (clusters.size() < 2) return clusters;
        std::vector<Lights> strata;
        for (const std::vector<std::size_t>& stratum : stratified(measured(clusters))) {
            Lights& lights = strata.emplace_back();
            for (const std::size_t c : stratum)
                lights.insert(lights.end(), clusters[c].begin(), clusters[c].end());
        }
        return strata;
    }

    const PhotonContext& photon_context() const { return photon_context_; }
    const PilotName& name() const { return name_; }
    const VisiblePointOctree& octree() const { return octree_; }
    const LightChoice& weights() const { return photon_context_.scene.scene.light_choice(); }

    Sets sets() const { return settings_.splitting ? Sets::as_needed : Sets::one; }

    /// @param context  must outlive the result.
    /// @param strata  number of strata: each is searched for.
    GuideSource maps(const SamplingContext& context, std::size_t strata) const {
        if (!settings_.emission_guide || !settings_.guide_search ||
            photon_context_.index.points().empty() || context.lights.empty())
            return {settings_.emission_guide};
        return {true,
                [this, &context](PassId pass, const PathRange& walks) {
                    return trace_importons(photon_context_, context.lights, pass, walks);
                },
                [this, &context](PassId pass, const PathRange& tries) {
                    return emission_past_edges(photon_context_, context.lights, pass, tries);
                },
                [this](PassId pass) { return flux_seen(photon_context_, pass); },
                static_cast<std::size_t>(work_ / (kPathsOfAWalk * strata))};
    }

private:
    /// Measures visible fractions by a few paths per cluster, and more where these are too few.
    std::vector<MeasuredLight> measured(const std::vector<Lights>& clusters) const {
        constexpr std::uint64_t kEnough = 2 * kFractionsApart;
        std::vector<MeasuredLight> lights = measured(
            clusters,
            std::clamp(kPathsOfAllLights / clusters.size(), kLeastLightPaths, kMostLightPaths), 0);
        const std::size_t more = kMostPathsOfAllLights / clusters.size();
        const bool tells = std::any_of(lights.begin(), lights.end(),
                                       [](const MeasuredLight& l) { return l.visible >= kEnough; });
        if (tells || more < 2 * lights.front().paths) return lights;
        return measured(clusters, more, 1);
    }

    std::vector<MeasuredLight> measured(const std::vector<Lights>& clusters, std::size_t paths,
                                        std::uint32_t iteration) const {
        std::vector<MeasuredLight> lights;
        for (const Lights& cluster : clusters) {
            const SamplingContext context(photon_context_, octree_, weights().among(cluster));
            const PilotName name{name_.seed, name_.epoch, kMeasuring};
            Statistics unused;
            const LevelCounts counts =
                uniform_level(context.space, EmissionPoints(name.iteration(iteration)),
                              static_cast<std::uint32_t>(paths), kHeights, unused)
                    .counts;
            lights.push_back({context.lights.total(), paths, counts.at_least(kVisible)});
        }
        return lights;
    }

    const PhotonContext& photon_context_;
    const PhotonSettings& settings_;
    PilotName name_;
    std::uint64_t work_;
    VisiblePointOctree octree_;
};

/// The lights by stratum, each explored by a pilot of its own.
class Pilots {
public:
    Pilots(const LightSurvey& survey, std::vector<LightChoice> strata)
        : power_(survey.weights().total()) {
        for (LightChoice& lights : strata) {
            contexts_.push_back(std::make_unique<SamplingContext>(
                survey.photon_context(), survey.octree(), std::move(lights)));
            const SamplingContext& context = *contexts_.back();
            pilots_.emplace_back(context.space, survey.name(), survey.maps(context, strata.size()),
                                 survey.sets());
            const HeightTail& tail = pilots_.back().explore();
            fluxes_.push_back({context.lights.total(), tail[kVisible], is_rare(tail)});
        }
    }

    std::vector<LightStratum> plan(std::uint32_t paths) {
        const std::vector<std::uint32_t> shares = shared_paths(fluxes_, paths);
        std::vector<LightStratum> strata;
        for (std::size_t g = 0; g < pilots_.size(); ++g) {
            PilotResult learned = pilots_[g].plan(shares[g]);
            strata.push_back({contexts_[g]->lights, std::move(learned.plan),
                              std::move(learned.guided), power_ > 0 ? fluxes_[g].power / power_ : 1,
                              static_cast<std::uint32_t>(g)});
        }
        return strata;
    }

private:
    double power_;  // of all lights
    std::vector<std::unique_ptr<SamplingContext>> contexts_;
    std::vector<PhotonPilot> pilots_;
    std::vector<StratumFlux> fluxes_;
};

}  // namespace

/// Pilots run when a plan needs them.
struct LightPlanner::State {
    LightSurvey survey;
    std::vector<Lights> strata;
    std::optional<Pilots> together;
    std::optional<Pilots> apart;

    explicit State(LightSurvey all) : survey(std::move(all)) {}
};

LightPlanner::LightPlanner(const PhotonContext& photon_context, const PhotonSettings& settings,
                           const PilotName& name, std::uint64_t work)
    : state_(std::make_unique<State>(LightSurvey(photon_context, settings, name, work))) {
    if (settings.light_strata) state_->strata = state_->survey.strata();
}

LightPlanner::~LightPlanner() = default;

std::vector<LightStratum> LightPlanner::plan(std::uint32_t paths) {
    State& l = *state_;
    const LightChoice& all = l.survey.weights();
    if (l.strata.size() < 2 || paths < 2 * l.strata.size()) {
        if (!l.together) l.together.emplace(l.survey, std::vector{all});
        return l.together->plan(paths);
    }
    if (!l.apart) {
        std::vector<LightChoice> choices;
        for (const Lights& lights : l.strata) choices.push_back(all.among(lights));
        l.apart.emplace(l.survey, std::move(choices));
    }
    return l.apart->plan(paths);
}

}  // namespace sunfleck::engine
