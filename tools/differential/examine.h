// All that is asked of one scene.
#pragma once

#include "differential/make_scene.h"
#include "differential/renders.h"

#include <vector>

namespace sunfleck::engine::differential {

/// How much is asked.
struct Effort {
    bool with_bytes = true;      // threads, interrupt, resume
    bool with_discs = false;     // discs of the default radius, and error bars
    bool until_decided = false;  // look twice where the first look leaves it open, too
    double significance = 1e-5;  // of a scene: a false alarm in so many
};

/// The estimators of a scene.
struct Witnesses {
    bool found_by_path = true;  // all light: see is_found_by_path
    std::string second;         // "none", or a further one that is compared with the reference
};

struct Findings {
    std::vector<Fault> faults;
    Verdict light = Verdict::undecided;  // default and reference, mean and blocks
    Verdict mean = Verdict::undecided;   // the same, mean alone
    std::string light_text;
    std::optional<Excess> excess;  // of the mean of a first look, default over reference
    double seconds = 0;
};

/// Renders the scene by the default and by the other estimators, and compares them.
Findings examine(Renders& renders, const Witnesses& witnesses, const Effort& effort);

/// Whether the scene has a fault of that kind: asks no more than this needs.
bool has_fault(Renders& renders, const Witnesses& witnesses, Kind kind);

}  // namespace sunfleck::engine::differential
