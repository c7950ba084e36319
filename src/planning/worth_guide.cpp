// Rounds of trials, whose union is a sample of a mixture of all guides so far.
#include "planning/worth_guide.h"

#include "core/parallel.h"
#include "photon/caster_samples.h"
#include "planning/path_trials.h"
#include "planning/trial_iterations.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kTrials = 50'000;  // of a round
constexpr std::size_t kCasterSamples = 50'000;

constexpr EmissionGuide::Growth kGrowth{0.05, 4, 0.01};
/// Of the guide's mass: a lasting share of where samples of casters and trials were.
constexpr double kKept = 0.3;
/// Of the picture's brightness: pixels darker than that are no worse than it.
constexpr double kLeastBrightness = 0.05;
/// Of all trials' weight: one that met a hole of the guide must not become its only goal.
constexpr double kMostOfAll = 0.002;

class WorthLearner {
public:
    WorthLearner(const PhotonContext& context, const PixelWindow& window, const CameraTrial& seen,
                 const PilotName& name)
        : context_(context),
          lights_(context.scene.scene.light_choice()),
          grid_(window),
          name_(name),
          unlit_(grid_.sums(luminance_of(seen.image))) {}

    EmissionGuide learn() {
        samples_ = caster_samples(context_.scene, lights_, name_.iteration(kCasterIteration),
                                  {0, kCasterSamples});
        double flux = 0;
        for (const WeightedEmission& sample : samples_) flux += sample.weight;
        if (!(flux > 0)) return {};
        for (WeightedEmission& sample : samples_) sample.weight /= flux;
        EmissionGuide guide = EmissionGuide::learned(samples_, kGrowth);
        for (std::uint32_t round = 0; round < kWorthRounds; ++round) {
            const PassId pass = name_.iteration(kWorthIteration + round);
            rounds_.push_back({guide, try_paths(context_, lights_, guide, grid_, pass, kTrials)});
            guide = corrected();
        }
        return guide;
    }

private:
    struct Round {
        EmissionGuide guide;
        PathTrials trials;
    };

    /// What a path brought, over the density of all trials where it started.
    struct Brought {
        EmissionPoint point{};
        double density = 0;
        std::size_t begin = 0;  // of its light in `light`
        std::size_t end = 0;
    };

    /// Returns the guide that all rounds together suggest.
    EmissionGuide corrected() const {
        std::vector<PathLight> light;
        const std::vector<Brought> paths = brought(light);
        const std::vector<double> brightness = this->brightness(paths, light);
        std::vector<EmissionGuide::Worth> trials;
        std::vector<WeightedEmission> points;
        double all = 0;
        for (const Brought& path : paths) {
            double worth = 0;
            for (std::size_t i = path.begin; i < path.end; ++i)
                worth += light[i].luminance / brightness[light[i].block];
            trials.push_back({path.point, worth * worth / path.density});
            if (!(worth > 0)) continue;
            points.push_back({path.point, worth / path.density});
            all += points.back().weight;
        }
        for (WeightedEmission& point : points)
            point.weight = (1 - kKept) * std::min(point.weight / all, kMostOfAll);
        for (WeightedEmission sample : samples_) {
            sample.weight *= kKept;
            points.push_back(sample);
        }
        return EmissionGuide::learned(std::move(points), kGrowth).by_worth(trials, kKept, kGrowth);
    }

    /// Returns all paths of all rounds, in order.
    /// @param light  receives theirs.
    std::vector<Brought> brought(std::vector<PathLight>& light) const {
        std::vector<Brought> paths;
        for (const Round& round : rounds_) {
            auto next = round.trials.light.begin();
            for (std::uint32_t path = 0; path < round.trials.points.size(); ++path) {
                Brought& one = paths.emplace_back();
                one.point = round.trials.points[path];
                one.begin = light.size();
                for (; next != round.trials.light.end() && next->path == path; ++next)
                    light.push_back(*next);
                one.end = light.size();
            }
        }
        constexpr std::size_t kBlock = 1024;
        parallel_blocks(paths.size(), kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) paths[i].density = density(paths[i]);
        });
        return paths;
    }

    /// Returns the expected number of trials per volume: of all rounds, a mixture. One for paths
    /// that brought nothing, for which nobody asks.
    double density(const Brought& path) const {
        if (path.begin == path.end) return 1;
        double sum = 0;
        for (const Round& round : rounds_) sum += kTrials * round.guide.density(path.point);
        return sum;
    }

    /// Returns the brightness of a pixel of each block, and the least that counts added.
    std::vector<double> brightness(const std::vector<Brought>& paths,
                                   const std::vector<PathLight>& light) const {
        std::vector<double> blocks = unlit_;
        for (const Brought& path : paths)
            for (std::size_t i = path.begin; i < path.end; ++i)
                blocks[light[i].block] += light[i].luminance / path.density;
        double all = 0;
        double pixels = 0;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            all += blocks[b];
            pixels += grid_.pixels(b);
        }
        for (std::size_t b = 0; b < blocks.size(); ++b)
            blocks[b] = blocks[b] / grid_.pixels(b) + kLeastBrightness * all / pixels;
        return blocks;
    }

    const PhotonContext& context_;
    const LightChoice& lights_;
    WorthBlocks grid_;
    PilotName name_;
    std::vector<double> unlit_;              // light that needs no photon, by block
    std::vector<WeightedEmission> samples_;  // of casters
    std::vector<Round> rounds_;
};

}  // namespace

EmissionGuide learned_worth_guide(const PhotonContext& context, const PixelWindow& window,
                                  const CameraTrial& seen, const PilotName& name) {
    return WorthLearner(context, window, seen, name).learn();
}

}  // namespace sunfleck::engine
