// The radius of pass p over that of pass 0: a function of the pass number alone.
//
// Source: Knaus and Zwicker 2011, "Progressive Photon Mapping: A Probabilistic Approach", eq. 20:
// r^2_{p+1} = r^2_p (p + alpha) / (p + 1), p from 1.
#pragma once

#include <cmath>
#include <cstdint>

namespace sunfleck {

/// @param pass  from 0. @param alpha  in (0,1): 2/3 balances bias and variance.
inline double radius_factor(std::uint32_t pass, double alpha) {
    double squared = 1;
    for (std::uint32_t p = 1; p <= pass; ++p) squared *= (p + alpha) / (p + 1.0);
    return std::sqrt(squared);
}

}  // namespace sunfleck
