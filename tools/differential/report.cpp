// Counts by kind and by verdict, and the pairs that are missing.
#include "differential/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine::differential {
namespace {

std::string text_of(const std::array<std::size_t, 3>& by_verdict) {
    std::string text;
    for (const Verdict verdict : {Verdict::equal, Verdict::undecided, Verdict::different})
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                            by_verdict[static_cast<std::size_t>(verdict)], name(verdict));
    return text;
}

}  // namespace

void Report::add(const Choice& choice, const Findings& findings) {
    ++scenes_;
    if (findings.excess) evidence_.add(choice, *findings.excess);
    seconds_ += findings.seconds;
    for (const Fault& fault : findings.faults) ++by_kind_.at(static_cast<std::size_t>(fault.kind));
    ++by_verdict_.at(static_cast<std::size_t>(findings.light));
    ++by_mean_.at(static_cast<std::size_t>(findings.mean));
}

std::size_t Report::faults() const {
    std::size_t count = evidence_.faults().size();
    for (const std::size_t one : by_kind_) count += one;
    return count;
}

std::string Report::text(const PairCoverage& coverage, double seconds) const {
    std::string text = fmt::format(
        "{} scenes, {:.0f} s ({:.1f} s of processor time a scene)\n"
        "pairs of feature values covered: {} of {}\n"
        "default and reference: mean {}; mean and blocks {}\n",
        scenes_, seconds, seconds_ / static_cast<double>(scenes_ > 0 ? scenes_ : 1),
        coverage.covered(), coverage.possible(), text_of(by_mean_), text_of(by_verdict_));
    text += fmt::format("faults: {}\n", faults());
    for (std::size_t k = 0; k < by_kind_.size(); ++k)
        if (by_kind_[k] > 0)
            text += fmt::format("  {}: {}\n", name(static_cast<Kind>(k)), by_kind_[k]);
    return text + text_of_features() + text_of_missing(coverage);
}

std::string Report::text_of_features() const {
    constexpr std::size_t kShown = 5;
    std::string text;
    const auto tell = [&](const std::string& what, const SharedExcess& one) {
        const Feature& feature = (*features_)[one.feature];
        text += fmt::format("  {} {} \"{}\": {} scenes, default over reference {:.4f} +- {:.4f}\n",
                            what, feature.name, feature.values[one.value], one.scenes,
                            1 + one.excess.value, one.excess.error);
    };
    for (const SharedExcess& fault : evidence_.faults()) tell("FAULT", fault);
    const std::vector<SharedExcess> all = evidence_.shared();
    for (std::size_t i = 0; i < all.size() && i < kShown; ++i) tell("least likely:", all[i]);
    return text;
}

std::string Report::text_of_missing(const PairCoverage& coverage) const {
    constexpr std::size_t kShown = 20;
    const FeatureTable& features = *features_;
    const auto missing = coverage.missing();
    std::string text;
    for (std::size_t i = 0; i < missing.size() && i < kShown; ++i)
        text +=
            fmt::format("  missing: {} \"{}\" with {} \"{}\"\n", features[missing[i].f].name,
                        features[missing[i].f].values[missing[i].a], features[missing[i].g].name,
                        features[missing[i].g].values[missing[i].b]);
    if (missing.size() > kShown) text += fmt::format("  and {} more\n", missing.size() - kShown);
    return text;
}

}  // namespace sunfleck::engine::differential
