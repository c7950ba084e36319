// Sums over the trials of all rounds.
#include "planning/worth_rounds.h"

#include "core/parallel.h"
#include "planning/worth_tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {

WorthRounds::WorthRounds(std::vector<WeightedEmission> casters) : casters_(std::move(casters)) {
    double flux = 0;
    for (const WeightedEmission& sample : casters_) flux += sample.weight;
    if (!(flux > 0)) casters_.clear();
    for (WeightedEmission& sample : casters_) sample.weight /= flux;
    over_casters_ =
        std::make_shared<const EmissionGuide>(EmissionGuide::learned(casters_, kCasterGrowth));
}

std::size_t WorthRounds::add(EmissionGuide guide, const PathTrials& trials) {
    constexpr std::size_t kBlock = 1024;
    const std::size_t before = paths_.size();
    std::size_t visible = 0;
    auto next = trials.light.begin();
    for (std::uint32_t path = 0; path < trials.points.size(); ++path) {
        const std::size_t begin = light_.size();
        for (; next != trials.light.end() && next->path == path; ++next) light_.push_back(*next);
        paths_.push_back({trials.points[path], 1, begin, light_.size()});
        if (light_.size() > begin) ++visible;
    }
    rounds_.push_back({std::move(guide), static_cast<double>(trials.points.size())});
    const Round& latest = rounds_.back();
    parallel_blocks(paths_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Brought& path = paths_[i];
            if (path.begin == path.end) continue;
            if (i < before)
                path.density += latest.trials * latest.guide.density(path.point);
            else
                path.density = density(path.point);
        }
    });
    return visible;
}

double WorthRounds::density(const EmissionPoint& at) const {
    double sum = 0;
    for (const Round& round : rounds_) sum += round.trials * round.guide.density(at);
    return sum;
}

std::vector<double> WorthRounds::scales(const WorthScale& scale) const {
    std::vector<double> blocks = scale.unlit;
    for (const Brought& path : paths_)
        for (std::size_t i = path.begin; i < path.end; ++i)
            blocks[light_[i].block] += light_[i].luminance / path.density;
    std::vector<double> scales = squared_scales(scale.blocks, blocks, scale.objective);
    for (double& s : scales) s = std::sqrt(s);
    return scales;
}

WorthRounds::Advice WorthRounds::advice(const WorthScale& scale, double over_casters) const {
    if (!have_found()) return {*over_casters_, {}};
    const std::vector<double> scales = this->scales(scale);
    std::vector<EmissionGuide::Worth> trials;
    Advice advice;
    double all = 0;
    for (const Brought& path : paths_) {
        double worth = 0;
        for (std::size_t i = path.begin; i < path.end; ++i)
            worth += light_[i].luminance / scales[light_[i].block];
        trials.push_back({path.point, worth * worth / path.density});
        if (!(worth > 0)) continue;
        advice.parts.push_back({path.point, worth / path.density});
        all += advice.parts.back().weight;
    }
    std::vector<WeightedEmission> points;
    for (Part& part : advice.parts) {
        part.weight = std::min(part.weight / all, kMostOfAllWorth);
        points.push_back({part.point, (1 - kWorthKept) * part.weight});
    }
    for (const WeightedEmission& sample : casters_)
        points.push_back({sample.point, kWorthKept * sample.weight});
    advice.guide = EmissionGuide::learned(std::move(points), kWorthGrowth)
                       .by_worth(trials, kWorthKept, kWorthGrowth)
                       .mixed_with(over_casters_, over_casters);
    return advice;
}

}  // namespace sunfleck::engine
