// Rounds of trials, and the bound of weights that they suggest.
#include "planning/worth_guide.h"

#include "photon/caster_samples.h"
#include "planning/epoch.h"
#include "planning/judged_blocks.h"
#include "planning/trial_iterations.h"
#include "planning/worth_tuning.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// A part of all worth.
struct WorthPart {
    double density;  // of the guide there
    double worth;
};

/// Returns the bound of weights that leaves kLeftToChains of all worth.
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
        const double bound = (worth - kLeftToChains * all) / brought;
        if (i + 1 == parts.size() || bound * parts[i + 1].density >= 1) return bound;
    }
    return kUnbounded;
}

WorthGuide with_bound(WorthRounds::Advice advice) {
    std::vector<WorthPart> parts;
    for (const WorthRounds::Part& part : advice.parts)
        parts.push_back({advice.guide.density(part.point), part.weight});
    WorthGuide result;
    result.plan.map = std::move(advice.guide);
    result.plan.most_weight = bound_of_weights(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].density * result.plan.most_weight < 1)
            result.bounded.push_back(advice.parts[i]);
    return result;
}

/// Runs rounds of trials for the visible points of an epoch.
class WorthLearner {
public:
    WorthLearner(const PhotonContext& context, const WorthScale& scale, const PilotName& name,
                 std::uint32_t paths)
        : context_(context), scale_(scale), name_(name), paths_(paths) {}

    /// Begins with samples of casters. @param boxes  see WorthStart.
    WorthRounds first_rounds(const EmissionGuide& boxes) const {
        const std::uint32_t trials =
            std::clamp(paths_ / kPartsOfAPass, kLeastWorthTrials, kMostFirstTrials);
        WorthRounds rounds(caster_samples(context_.scene, context_.scene.scene.light_choice(),
                                          name_.iteration(kCasterIteration), {0, trials}));
        if (rounds.are_idle()) return rounds;
        if (!boxes.is_identity()) add_round(rounds, boxes, kBoxesIteration, trials);
        std::size_t before = 0;
        for (std::uint32_t round = 0; round < kMostWorthRounds; ++round) {
            const std::size_t visible = add_next(rounds, round, trials);
            if (round + 1 >= kLeastRounds && kFewVisible * visible >= trials &&
                2 * visible < 3 * before)
                break;
            before = visible;
        }
        return rounds;
    }

    /// Goes on where an earlier epoch ended.
    void add_rounds(WorthRounds& rounds) const {
        const double all = kWorthEffort * passes_of_epoch(name_.epoch) * paths_ / kLaterRounds;
        const auto trials = static_cast<std::uint32_t>(
            std::clamp<double>(all, kLeastWorthTrials, kMostLaterTrials));
        for (std::uint32_t round = 0; round < kLaterRounds; ++round)
            add_next(rounds, round, trials);
    }

private:
    /// Adds trials through a guide. @return the number of those that brought any light.
    std::size_t add_round(WorthRounds& rounds, EmissionGuide guide, std::uint32_t iteration,
                          std::uint32_t trials) const {
        const PathTrials tried =
            try_paths(context_, guide, scale_.blocks, name_.iteration(iteration), trials);
        return rounds.add(std::move(guide), tried);
    }

    /// The same, through the guide that the rounds so far suggest.
    std::size_t add_next(WorthRounds& rounds, std::uint32_t number, std::uint32_t trials) const {
        return add_round(rounds, rounds.advice(scale_, kOverCastersInTrials).guide,
                         kWorthIteration + number, trials);
    }

    const PhotonContext& context_;
    const WorthScale& scale_;
    PilotName name_;
    std::uint32_t paths_;  // of a pass
};

}  // namespace

WorthGuide learned_worth_guide(const PhotonContext& context, const PixelWindow& window,
                               const CameraTrial& seen, const PilotName& name,
                               const WorthRequest& request) {
    const BlockGrid blocks = judged_blocks(window, seen.cells);
    const std::vector<double> unlit = block_sums(blocks, luminance_of(seen.image));
    const WorthScale scale{blocks, unlit, request.objective};
    const WorthLearner learner(context, scale, name, request.paths);
    WorthRounds rounds =
        request.start.earlier ? *request.start.earlier : learner.first_rounds(request.start.boxes);
    if (rounds.are_idle()) return {};
    if (request.start.earlier) learner.add_rounds(rounds);
    WorthGuide guide = with_bound(rounds.advice(scale, kOverCasters));
    guide.rounds = std::make_shared<const WorthRounds>(std::move(rounds));
    return guide;
}

}  // namespace sunfleck::engine
