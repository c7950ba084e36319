// Rules that choose the levels of multilevel splitting by the rarity of visible paths, without the
// sampling.
#pragma once

#include "chains/learned_guide.h"

#include <array>

namespace sunfleck::engine {

/// P(height >= h) of a uniform path, by h; zero where none was found.
using HeightTail = std::array<double, kHeights>;

/// Returns whether splitting pays: fewer than one path in 20 is visible.
bool is_rare(const HeightTail& tail);

/// Number of level sets allowed.
enum class Sets { as_needed, one };

/// Returns the plan of a pass, with initial scales.
/// - If visible paths are not rare: uniform paths alone.
/// - Otherwise half of the paths are states of the last set. If the other half, uniform, would find
/// 64 visible paths or more: one set.
/// - Otherwise the smallest number of sets with a mean conditional fraction of at most 0.05;
/// heights are those with tails nearest to even steps.
/// - If no visible path was found: a set at each height that at most a fifth of the paths of the
/// previous set reached.
/// @param paths  of a pass, all levels together; at least 2.
/// @param sets  one: of several sets only the last, whose chains start at the visible paths there
/// are.
SplittingPlan splitting_plan(const HeightTail& tail, std::uint32_t paths,
                             Sets sets = Sets::as_needed);

/// Guided paths, and splitting beside them.
struct SharedPlan {
    SplittingPlan splitting;
    GuidedPlan guided;
};

/// Returns the plan with a guide. Light of the guided region is computed by
/// - guided paths; chains of splitting contribute what the guide does not cover;
/// - those chains as well, started from guided paths, if less than a fifth of these is visible.
/// A guide for regions that splitting does not reach gets most of the paths.
/// @param tail  of all paths.
/// @param map  with a rest below one.
/// @param paths  at least 2.
SharedPlan shared_plan(HeightTail tail, const LearnedGuide& map, std::uint32_t paths,
                       Sets sets = Sets::as_needed);

/// Returns the next height of exploration: the greatest with at least 2% of the states; else the
/// lowest above `from` that has any; else kHeights.
/// @param from  height of the set of the states.
int next_height(const HeightCounts& heights, int from);

}  // namespace sunfleck::engine
