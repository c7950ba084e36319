// Systematic resampling: divides N things among M shares with one random offset.
//
// All shares have the same distribution, and they sum to N exactly. A single offset makes no share
// depend on what it is used for (docs/method/sampling.md).
//
// In:  integers and one uniform random number. Out: integers, by exact arithmetic.
// Source: Carpenter, Clifford, Fearnhead, Improved particle filter for nonlinear problems (1999).
#pragma once

#include <cstdint>

namespace sunfleck::engine {

/// Returns a uniform integer in [0, n), up to a bias of 2^-32. @param n  1 to 2^32 - 1.
constexpr std::uint64_t below(std::uint64_t fraction, std::uint64_t n) {
    return ((fraction >> 32U) * n) >> 32U;
}

/// Divides `things` into `shares`, each the floor or the ceiling of the quotient.
class SystematicResampling {
public:
    /// @param things, shares  below 2^31; shares at least 1.
    /// @param fraction  uniform random number.
    constexpr SystematicResampling(std::uint64_t things, std::uint64_t shares,
                                   std::uint64_t fraction)
        : things_(things), shares_(shares), offset_(below(fraction, shares)) {}

    constexpr std::uint64_t operator()(std::uint64_t share) const {
        return ((share + 1) * things_ + offset_) / shares_ - (share * things_ + offset_) / shares_;
    }

private:
    std::uint64_t things_;
    std::uint64_t shares_;
    std::uint64_t offset_;
};

}  // namespace sunfleck::engine
