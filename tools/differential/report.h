// What a campaign found, as text.
#pragma once

#include "differential/covering.h"
#include "differential/examine.h"

#include <array>
#include <string>

namespace sunfleck::differential {

class Report {
public:
    void add(const Findings& findings);
    /// @param features  the table that the coverage is of.
    std::string text(const FeatureTable& features, const PairCoverage& coverage,
                     double seconds) const;
    std::size_t faults() const;

private:
    std::array<std::size_t, 8> by_kind_{};
    std::array<std::size_t, 3> by_verdict_{};
    std::array<std::size_t, 3> by_mean_{};
    std::size_t scenes_ = 0;
    double seconds_ = 0;
};

}  // namespace sunfleck::differential
