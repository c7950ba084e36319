// What the statistical tests of laws share.
#pragma once

namespace sunfleck::engine {

/// Of each test: the probability with which it fails though the law holds. Seeds are fixed.
inline constexpr double kSignificance = 1e-4;

}  // namespace sunfleck::engine
