// Sharing N things evenly among M by one random offset: each share has the same distribution, and
// the shares sum to N exactly.
//
// In:  whole numbers and one uniform random number. Out: whole numbers; exact integer arithmetic.
// Why one offset: no share then depends on what it is a share for (docs/method/method.md).
#pragma once

#include <cstdint>

namespace sunfleck::engine {

/// Uniform in [0, n), up to a part in 2^32. @param n  1 to 2^32 - 1.
constexpr std::uint64_t below(std::uint64_t fraction, std::uint64_t n) {
    return ((fraction >> 32U) * n) >> 32U;
}

/// Cuts `things` into `shares` lengths, each either floor or ceiling of the quotient.
class SystematicResampling {
public:
    /// @param things, shares  below 2^31; shares at least 1. @param fraction  uniform.
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
