// Chooses the levels of multilevel splitting by how rare visible paths are: the rules, without the
// sampling.
#pragma once

#include "chains/learned_guide.h"

#include <array>

namespace sunfleck::engine {

/// P(height >= h) of a uniform path, by h; zero where none was found.
using HeightTail = std::array<double, kHeights>;

/// True if visible paths are so rare that splitting pays: less than one in 20.
bool is_rare(const HeightTail& tail);

/// How many level sets there may be.
enum class Sets { as_needed, one };

/// The plan of a pass, its scales left as they start.
/// - Where they are not rare: uniform paths alone.
/// - Else half of the paths are states of the last set. If the other half, uniform, would find 64
///   visible paths or more: one set.
/// - Else the least number of sets whose conditional fractions are 0.05 or less on average; the
///   heights are those whose tail is nearest to even steps.
/// - No visible path found: a set at each height that was reached by a fifth or less of the paths
///   of the set before.
/// @param paths  of a pass, all levels together; at least 2. @param sets  one: where there would be
/// several, only the last, whose chains start at what visible paths there are.
SplittingPlan splitting_plan(const HeightTail& tail, std::uint32_t paths,
                             Sets sets = Sets::as_needed);

/// Guided paths, and splitting beside them.
struct SharedPlan {
    SplittingPlan splitting;
    GuidedPlan guided;
};

/// The plan where there is a guide. The light of the guided region is brought
/// - by guided paths, and the chains of splitting bring what the guide leaves out;
/// - by those chains, too, started from guided paths, where less than a fifth of these is visible.
/// A guide of places that splitting does not reach gets most of the paths.
/// @param tail  of all paths. @param map  of which the rest is less than one. @param paths  at
/// least 2.
SharedPlan shared_plan(HeightTail tail, const LearnedGuide& map, std::uint32_t paths,
                       Sets sets = Sets::as_needed);

/// The height that exploration climbs to next: the greatest with at least 2% of the states; if no
/// height above the set's has so many, the lowest above it that has any; kHeights if none has.
/// @param from  the height of the set that the states are of.
int next_height(const HeightCounts& heights, int from);

}  // namespace sunfleck::engine
