// Evidence of many scenes together: by how much the default differs from the reference where a
// feature has a value.
//
// A light that is 3% too bright hides in the noise of each scene. The mean over all scenes that
// have it shows it.
#pragma once

#include "differential/equivalence.h"
#include "differential/features.h"

#include <string>
#include <vector>

namespace sunfleck::engine::differential {

/// What the scenes with one value of a feature have in common.
struct SharedExcess {
    std::size_t feature = 0;  // of the table
    Value value = 0;
    std::size_t scenes = 0;
    Excess excess;
    double chance = 1;  // of as much or more beyond the band, were the excess within it
};

class FeatureEvidence {
public:
    explicit FeatureEvidence(const FeatureTable& table) : table_(&table) {}

    void add(const Choice& choice, const Excess& excess) { scenes_.push_back({choice, excess}); }
    /// Of each value that at least kFewestScenes have, the least likely first.
    std::vector<SharedExcess> shared() const;
    /// Those of them that are faults, each by scenes that have none of the values before it; 1% of
    /// campaigns without any have one.
    std::vector<SharedExcess> faults() const;

    static constexpr std::size_t kFewestScenes = 8;

private:
    struct Scene {
        Choice choice;
        Excess excess;
    };
    bool has(const Scene& scene, std::size_t feature, Value value) const;

    const FeatureTable* table_;
    std::vector<Scene> scenes_;
};

}  // namespace sunfleck::engine::differential
