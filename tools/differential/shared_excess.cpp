// A weighted mean over scenes, whose error is that which the scenes themselves show.
#include "differential/shared_excess.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine::differential {
namespace {

/// What does not matter of a shared excess.
constexpr double kBand = 0.005;
constexpr double kFalseAlarms = 0.01;  // of a campaign
/// Added to the error of each scene. No scene then speaks for all, and its weight hardly depends on
/// its own noise: by four renders small errors go with small values, and weights by them alone have
/// a bias.
constexpr double kLeastError = 0.02;

Excess mean_of_scenes(const std::vector<Excess>& scenes) {
    double weights = 0;
    double sum = 0;
    const auto weight = [](const Excess& one) {
        return 1 / (one.error * one.error + kLeastError * kLeastError);
    };
    for (const Excess& one : scenes) {
        weights += weight(one);
        sum += weight(one) * one.value;
    }
    const double mean = sum / weights;
    double squares = 0;
    for (const Excess& one : scenes) {
        const double off = weight(one) * (one.value - mean);
        squares += off * off;
    }
    const auto count = static_cast<double>(scenes.size());
    return {mean, std::sqrt(squares * count / (count - 1)) / weights};
}

}  // namespace

bool FeatureEvidence::has(const Scene& scene, std::size_t feature, Value value) const {
    return scene.choice[feature] == value && table_->has_meaning(scene.choice, feature);
}

std::vector<SharedExcess> FeatureEvidence::shared() const {
    std::vector<SharedExcess> all;
    for (std::size_t f = 0; f < table_->size(); ++f)
        for (Value v = 0; v < (*table_)[f].values.size(); ++v) {
            std::vector<Excess> seen;
            for (const Scene& scene : scenes_)
                if (has(scene, f, v)) seen.push_back(scene.excess);
            if (seen.size() < kFewestScenes) continue;
            const Excess mean = mean_of_scenes(seen);
            const double beyond = std::abs(mean.value) - kBand;
            const double chance = 2 * student_tail(beyond / std::max(mean.error, 1e-30),
                                                   static_cast<double>(seen.size() - 1));
            all.push_back({f, v, seen.size(), mean, std::min(chance, 1.0)});
        }
    std::stable_sort(all.begin(), all.end(), [](const SharedExcess& a, const SharedExcess& b) {
        return a.chance < b.chance;
    });
    return all;
}

std::vector<SharedExcess> FeatureEvidence::faults() const {
    std::vector<SharedExcess> found;
    FeatureEvidence rest = *this;
    for (;;) {
        const std::vector<SharedExcess> all = rest.shared();
        const auto tests = static_cast<double>(all.size());
        if (all.empty() || all.front().chance > kFalseAlarms / tests) return found;
        const SharedExcess worst = all.front();
        found.push_back(worst);
        std::erase_if(rest.scenes_,
                      [&](const Scene& scene) { return has(scene, worst.feature, worst.value); });
    }
}

}  // namespace sunfleck::engine::differential
