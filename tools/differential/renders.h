// Renders of one scene, by several estimators and seeds.
#pragma once

#include "differential/faults.h"
#include "differential/look.h"
#include "differential/program.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine::differential {

/// An estimator: flags of `sunfleck render`, passes of one render, and a number that keeps its
/// seeds apart from those of other estimators.
struct Way {
    std::string name;
    Words flags;
    int passes = 16;  // a multiple of 16, the batch of wavelengths
    std::uint64_t seeds = 0;
};

namespace ways {
Way adaptive();
/// An estimator by photons that is a second witness: "uniform", "random" or "direct photons".
Way photons(const std::string& name);
Way path();
Way pairs();  // bidirectional
/// The same with discs so small that they have next to no bias.
Way with_small_discs(Way way);
/// The same with more passes, so that the bias of its discs is reported.
Way with_bias(Way way);
}  // namespace ways

/// Where a scene lies, and where its renders go.
struct Place {
    std::string scene;   // file
    std::string folder;  // of the renders
    std::uint64_t seed = 0;
    bool may_be_negative = false;  // a filter with negative lobes
};

class Renders {
public:
    Renders(const Program& program, Place place) : program_(&program), place_(std::move(place)) {}

    /// @throws RenderFault for a render that fails, or holds values that none may hold.
    Picture render(const Way& way, std::uint64_t index);
    /// Looks at renders with the indices [first, first + count).
    std::vector<Look> looks(const Way& way, std::uint64_t first, std::uint64_t count);
    /// Runs the program on the scene, whatever comes of it, within limits.
    Ended run(const Words& words, std::optional<std::chrono::milliseconds> interrupt_after = {});

    const Place& place() const { return place_; }
    /// Processor time of all runs.
    double seconds() const { return seconds_; }

private:
    const Program* program_;
    Place place_;
    double seconds_ = 0;
};

}  // namespace sunfleck::engine::differential
