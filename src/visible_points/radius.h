// Gather radius of a pass relative to pass 0, a function of the pass index alone.
//
// Source: Knaus and Zwicker 2011, "Progressive Photon Mapping: A Probabilistic Approach", eq. 20:
// r^2_{p+1} = r^2_p (p + alpha) / (p + 1), p from 1.
// Equations: docs/method/method.md, eq. (3).
#pragma once

#include <cmath>
#include <cstdint>

namespace sunfleck::engine {

/// Sequence of disc areas in passes 0, 1, 2 ..., relative to pass 0.
class DiscAreaSequence {
public:
    /// @param alpha  in (0,1): 2/3 balances bias and variance.
    explicit DiscAreaSequence(double alpha) : alpha_(alpha) {}

    /// Returns the area in the next pass, with the same bits on every machine.
    double next() {
        const auto p = static_cast<double>(pass_++);
        if (p > 0) area_ *= (p + alpha_) / (p + 1);
        return area_;
    }

private:
    double alpha_;
    double area_ = 1;
    std::uint64_t pass_ = 0;
};

/// Returns the radius of a pass relative to pass 0. @param pass  from 0. @param alpha  in (0,1).
inline double radius_factor(std::uint32_t pass, double alpha) {
    DiscAreaSequence areas(alpha);
    for (std::uint32_t p = 0; p < pass; ++p) areas.next();
    return std::sqrt(areas.next());
}

}  // namespace sunfleck::engine
