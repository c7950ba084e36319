// Rounds of trials, whose union is a sample of a mixture of all guides so far.
#include "planning/worth_guide.h"

#include "core/parallel.h"
#include "photon/caster_samples.h"
#include "planning/path_trials.h"
#include "planning/trial_iterations.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Trials of a round, and samples of casters: so many parts of a pass have as many paths.
constexpr std::uint32_t kPartsOfAPass = 4;
constexpr std::uint32_t kLeastTrials = 2000;
constexpr std::uint32_t kMostTrials = 50'000;

/// Rounds go on while few trials are visible, one of so many, or many more than in the round
/// before.
constexpr std::uint32_t kLeastRounds = 3;
constexpr std::size_t kFew = 50;

constexpr EmissionGuide::Growth kGrowth{.uniform_share = 0.05, .least_gain = 4, .spread = 0.01};
/// Of the guide's mass: a lasting share of where samples of casters and trials were.
constexpr double kKept = 0.3;
/// Of all trials' weight: one that met a hole of the guide must not become its only goal.
constexpr double kMostOfAll = 0.002;

/// Of all worth: what a bound of the weights leaves to chains.
constexpr double kLeft = 0.01;

/// A part of all worth.
struct WorthPart {
    double density;  // of the guide there
    double worth;
};

/// Returns the bound of weights that leaves kLeft of all worth.
double bound_of_weights(std::vector<WorthPart> parts) {
    std::sort(parts.begin(), parts.end(),
              [](const WorthPart& a, const WorthPart& b) { return a.density < b.density; });
    double all = 0;
    for (const WorthPart& part : parts) all += part.worth;
    // Sums over the parts that would weigh more than the bound.
    double worth = 0;
    double brought = 0;  // by paths of weight one
    for (std::size_t i = 0; i < parts.size(); ++i) {
        worth += parts[i].worth;
        brought += parts[i].worth * parts[i].density;
        const double bound = (worth - kLeft * all) / brought;
        if (i + 1 == parts.size() || bound * parts[i + 1].density >= 1) return bound;
    }
    return kUnbounded;
}

class WorthLearner {
public:
    WorthLearner(const PhotonContext& context, const PixelWindow& window, const CameraTrial& seen,
                 const PilotName& name, std::uint32_t paths, Objective objective)
        : context_(context),
          lights_(context.scene.scene.light_choice()),
          blocks_(judged_blocks(window)),
          name_(name),
          objective_(objective),
          trials_(std::clamp(paths / kPartsOfAPass, kLeastTrials, kMostTrials)),
          unlit_(block_sums(blocks_, luminance_of(seen.image))) {}

    WorthGuide learn() {
        samples_ = caster_samples(context_.scene, lights_, name_.iteration(kCasterIteration),
                                  {0, trials_});
        double flux = 0;
        for (const WeightedEmission& sample : samples_) flux += sample.weight;
        if (!(flux > 0)) return {};
        for (WeightedEmission& sample : samples_) sample.weight /= flux;
        EmissionGuide guide = EmissionGuide::learned(samples_, kGrowth);
        std::size_t before = 0;
        for (std::uint32_t round = 0; round < kMostWorthRounds; ++round) {
            const PassId pass = name_.iteration(kWorthIteration + round);
            const std::size_t visible =
                add_round(guide, try_paths(context_, guide, blocks_, pass, trials_));
            guide = corrected();
            if (round + 1 >= kLeastRounds && kFew * visible >= trials_ && 2 * visible < 3 * before)
                break;
            before = visible;
        }
        return with_bound(std::move(guide));
    }

private:
    /// What a trial brought.
    struct Brought {
        EmissionPoint point{};
        /// Expected number of trials per volume there: of all rounds, a mixture. One for a path
        /// that brought nothing, for which nobody asks.
        double density = 1;
        std::size_t begin = 0;  // of its light in light_
        std::size_t end = 0;
    };

    /// @return the number of trials that brought any light.
    std::size_t add_round(const EmissionGuide& guide, const PathTrials& trials) {
        constexpr std::size_t kBlock = 1024;
        const std::size_t before = paths_.size();
        std::size_t visible = 0;
        auto next = trials.light.begin();
        for (std::uint32_t path = 0; path < trials.points.size(); ++path) {
            const std::size_t begin = light_.size();
            for (; next != trials.light.end() && next->path == path; ++next)
                light_.push_back(*next);
            paths_.push_back({trials.points[path], 1, begin, light_.size()});
            if (light_.size() > begin) ++visible;
        }
        guides_.push_back(guide);
        parallel_blocks(paths_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Brought& path = paths_[i];
                if (path.begin == path.end) continue;
                if (i < before)
                    path.density += trials_ * guide.density(path.point);
                else
                    path.density = density(path.point);
            }
        });
        return visible;
    }

    double density(const EmissionPoint& at) const {
        double sum = 0;
        for (const EmissionGuide& guide : guides_) sum += trials_ * guide.density(at);
        return sum;
    }

    /// Returns the guide that all rounds together suggest.
    EmissionGuide corrected() {
        const std::vector<double> scales = this->scales();
        std::vector<EmissionGuide::Worth> trials;
        worth_.clear();
        double all = 0;
        for (const Brought& path : paths_) {
            double worth = 0;
            for (std::size_t i = path.begin; i < path.end; ++i)
                worth += light_[i].luminance / scales[light_[i].block];
            trials.push_back({path.point, worth * worth / path.density});
            if (!(worth > 0)) continue;
            worth_.push_back({path.point, worth / path.density});
            all += worth_.back().weight;
        }
        for (WeightedEmission& point : worth_)
            point.weight = std::min(point.weight / all, kMostOfAll);
        std::vector<WeightedEmission> points;
        for (const WeightedEmission& point : worth_)
            points.push_back({point.point, (1 - kKept) * point.weight});
        for (const WeightedEmission& sample : samples_)
            points.push_back({sample.point, kKept * sample.weight});
        return EmissionGuide::learned(std::move(points), kGrowth).by_worth(trials, kKept, kGrowth);
    }

    WorthGuide with_bound(EmissionGuide guide) const {
        std::vector<WorthPart> parts;
        for (const WeightedEmission& point : worth_)
            parts.push_back({guide.density(point.point), point.weight});
        WorthGuide result;
        result.plan.map = std::move(guide);
        result.plan.most_weight = bound_of_weights(parts);
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].density * result.plan.most_weight < 1) result.bounded.push_back(worth_[i]);
        return result;
    }

    /// Returns the scale of errors of each block.
    std::vector<double> scales() const {
        std::vector<double> blocks = unlit_;
        for (const Brought& path : paths_)
            for (std::size_t i = path.begin; i < path.end; ++i)
                blocks[light_[i].block] += light_[i].luminance / path.density;
        double all = 0;
        double pixels = 0;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            all += blocks[b];
            pixels += pixels_of(b);
        }
        for (std::size_t b = 0; b < blocks.size(); ++b)
            blocks[b] =
                std::sqrt(squared_scale(objective_, blocks[b] / pixels_of(b), all / pixels));
        return blocks;
    }

    double pixels_of(std::size_t block) const {
        return static_cast<double>(blocks_.block(block).pixels());
    }

    const PhotonContext& context_;
    const LightChoice& lights_;
    BlockGrid blocks_;
    PilotName name_;
    Objective objective_;
    std::uint32_t trials_;                   // of a round
    std::vector<double> unlit_;              // light that needs no photon, by block
    std::vector<WeightedEmission> samples_;  // of casters
    std::vector<EmissionGuide> guides_;      // of the rounds so far
    std::vector<Brought> paths_;             // of all rounds
    std::vector<PathLight> light_;           // of all paths, by path
    std::vector<WeightedEmission> worth_;    // of paths that brought light: parts of all worth
};

}  // namespace

WorthGuide learned_worth_guide(const PhotonContext& context, const PixelWindow& window,
                               const CameraTrial& seen, const PilotName& name, std::uint32_t paths,
                               Objective objective) {
    return WorthLearner(context, window, seen, name, paths, objective).learn();
}

}  // namespace sunfleck::engine
