// What a campaign found, as text.
#pragma once

#include "differential/covering.h"
#include "differential/examine.h"
#include "differential/shared_excess.h"

#include <array>
#include <string>

namespace sunfleck::engine::differential {

class Report {
public:
    /// @param features  the table that choices, and what was covered, are of.
    explicit Report(const FeatureTable& features) : features_(&features), evidence_(features) {}

    void add(const Choice& choice, const Findings& findings);
    std::string text(const PairCoverage& coverage, double seconds) const;
    /// Of scenes, and of features.
    std::size_t faults() const;

private:
    std::string text_of_missing(const PairCoverage& coverage) const;
    std::string text_of_features() const;

    const FeatureTable* features_;
    FeatureEvidence evidence_;
    std::array<std::size_t, 8> by_kind_{};
    std::array<std::size_t, 3> by_verdict_{};
    std::array<std::size_t, 3> by_mean_{};
    std::size_t scenes_ = 0;
    double seconds_ = 0;
};

}  // namespace sunfleck::engine::differential
