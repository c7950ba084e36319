// Which lights share their photon paths, and how many paths each stratum gets: the rules, without
// the sampling.
//
// In:  powers and visible fractions of lights. Out: strata, numbers of paths.
// Source: measured (docs/develop/decisions.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kMostStrata = 4;
/// Visible fractions that differ by no more than that may share a stratum.
inline constexpr std::uint64_t kFractionsApart = 30;

/// A light or a cluster of lights, and some uniform paths from it. All lists have equal `paths`.
struct MeasuredLight {
    double power = 0;  // positive, in any unit
    std::uint64_t paths = 0;
    std::uint64_t visible = 0;  // of these; none counts as less than one
};

/// Lights by stratum, the most visible stratum first: within a stratum visible fractions differ by
/// no more than kFractionsApart, but that
/// - a stratum whose power is below a tenth of that before it stays with it: it takes too few
/// paths
///   to be in the way;
/// - so does one before which there is less than a hundredth of its own visible flux;
/// - the last of kMostStrata holds all that is left.
std::vector<std::vector<std::size_t>> stratified(const std::vector<MeasuredLight>& lights);

/// What a stratum's pilot found.
struct StratumFlux {
    double power = 0;
    double visible_fraction = 0;
    bool has_splitting = false;  // half of its paths or more are visible then
};

/// Paths in proportion to what each stratum needs, visible flux over visible paths a path, or to a
/// tenth of what all need; at least two each.
/// @param paths  of all together: two a stratum or more.
std::vector<std::uint32_t> shared_paths(const std::vector<StratumFlux>& strata,
                                        std::uint32_t paths);

}  // namespace sunfleck::engine
