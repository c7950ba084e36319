// Objective: what a picture is judged by, the mean over blocks of pixels of Var / S².
// Equations: docs/method/sampling.md, eq. (40).
#pragma once

#include "core/named_rows.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class Objective { relative, absolute };

inline constexpr std::array<ChoiceRow<Objective>, 2> kObjectives = {{
    {Objective::relative, "relative", "errors over the brightness that is there"},
    {Objective::absolute, "absolute", "errors over the brightness of the picture"},
}};

inline std::string_view name_of(Objective objective) {
    return kObjectives.at(static_cast<std::size_t>(objective)).name;
}

/// Returns S², by which the variance of a place is divided. Relative: L_b² + .01 L², so that the
/// darkest places are no worse than those of a tenth of the picture's brightness.
/// @param brightness  L_b, of the place. @param mean  L, of the picture.
inline double squared_scale(Objective objective, double brightness, double mean) {
    constexpr double kDark = 0.01;
    return objective == Objective::absolute ? mean * mean
                                            : brightness * brightness + kDark * mean * mean;
}

}  // namespace sunfleck::engine
