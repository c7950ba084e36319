// Rules that divide lights into strata and photon paths among strata, without the sampling.
//
// In:  powers and visible fractions of lights. Out: strata, numbers of paths.
// Source: measured (docs/develop/decisions.md).
// Equations: docs/method/sampling.md, eq. (17).
#pragma once

#include "photon/strata_tuning.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// A light or cluster of lights with counts of uniform paths. All have equal `paths`.
struct MeasuredLight {
    double power = 0;  // positive, in any unit
    std::uint64_t paths = 0;
    std::uint64_t visible = 0;  // visible ones of these; zero counts as less than one
};

/// Divides lights into strata, the most visible stratum first. Visible fractions in a stratum
/// differ by at most kFractionsApart, except that
/// - a stratum with less than a tenth of the power of the one before is joined to it, because it
/// takes few paths;
/// - a stratum is joined to the one before if that has less than a hundredth of its visible flux;
/// - the last of kMostStrata holds all remaining lights.
std::vector<std::vector<std::size_t>> stratified(const std::vector<MeasuredLight>& lights);

/// What the pilot of a stratum found.
struct StratumFlux {
    double power = 0;
    double visible_fraction = 0;
    bool has_splitting = false;  // at least half of its paths are visible then
};

/// Divides paths in proportion to the need of each stratum (visible flux over visible paths per
/// path), with a minimum of a tenth of the mean; at least two each.
/// @param paths  of all strata; at least two per stratum.
std::vector<std::uint32_t> shared_paths(const std::vector<StratumFlux>& strata,
                                        std::uint32_t paths);

}  // namespace sunfleck::engine
