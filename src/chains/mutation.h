// Mutations of primary samples, and the adaptation of their scale.
//
// A mutation first draws its magnitude, log-uniform over three decades around the scale of its
// kind. Then every dimension moves by about that, log-uniform over one decade. So there are small
// mutations for narrow level sets, and large ones (docs/develop/decisions.md has the evidence). Two
// kinds are selected at random: all dimensions alike, or bounce dimensions 16 times as far as
// emission dimensions.
// Source: adaptive scale towards a target acceptance: paper, section 4.4 (its own rule: paper_step
// of photon/paper_chain.h).
// Equations: docs/method/sampling.md, eq. (14).
#pragma once

#include "chains/splitting_tuning.h"
#include "random_numbers/primary_sample.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace sunfleck::engine {

/// Counts of proposals of one kind, and of accepted ones.
struct Acceptance {
    std::uint64_t proposed = 0;
    std::uint64_t accepted = 0;

    Acceptance& operator+=(const Acceptance& other) {
        proposed += other.proposed;
        accepted += other.accepted;
        return *this;
    }
    /// Returns the acceptance; zero without proposals.
    double share() const {
        return proposed == 0 ? 0 : static_cast<double>(accepted) / static_cast<double>(proposed);
    }
    friend bool operator==(const Acceptance&, const Acceptance&) = default;
};
using Acceptances = std::array<Acceptance, kMutationKinds>;

/// The scale of each kind for emission dimensions, in units of the interval.
struct MutationScales {
    std::array<float, kMutationKinds> scale = {0.05F, 0.05F};

    friend bool operator==(const MutationScales&, const MutationScales&) = default;
};

/// Returns 2^x with a relative error of at most 1.1e-4, continuous and increasing. It has the same
/// bits on every machine, and calls no function.
/// @param x  from -100 to 100.
inline float approximate_exp2(float x) {
    const float whole = std::floor(x);
    const float part = x - whole;
    const float power = 1 + part * (0.6954F + part * (0.2264F + part * 0.0782F));
    const auto exponent = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole) + 127);
    return power * std::bit_cast<float>(exponent << 23U);
}

/// Returns 10^(decades (xi - 1/2)). @param random  uniform: its highest bits are xi.
inline float log_uniform(float decades, std::uint32_t random) {
    constexpr float kDoublingsOfADecade = 3.3219281F;  // ln(10) / ln(2)
    return approximate_exp2(decades * kDoublingsOfADecade * (word_to_unit_float(random) - 0.5F));
}

/// Moves by scale * 10^(xi - 1/2) to either side with wrap-around, symmetric to the last bit.
/// @param random  uniform: its lowest bit selects the side, its highest bits are xi.
inline std::uint64_t moved(std::uint64_t dimension, float scale, std::uint32_t random) {
    const double turns =
        static_cast<double>(scale) * static_cast<double>(log_uniform(kDecadesOfSteps, random));
    const double wrapped = turns - std::floor(turns);
    const auto step = static_cast<std::uint64_t>(wrapped * 0x1p64);
    return (random & 1U) != 0 ? dimension + step : dimension - step;
}

/// A mutation of one kind, dimension by dimension.
class LogUniformMove {
public:
    /// Draws the magnitude, which all dimensions share.
    LogUniformMove(const MutationScales& scales, std::size_t kind, RandomStream& stream)
        : emission_(scales.scale.at(kind) * log_uniform(kDecadesOfMagnitudes, stream.next_word())),
          bounce_(emission_ * kBounceStretch.at(kind)),
          stream_(stream) {}

    std::uint64_t operator()(std::uint32_t dimension, std::uint64_t value) {
        return moved(value, is_emission(dimension) ? emission_ : bounce_, stream_.next_word());
    }

private:
    float emission_;
    float bounce_;
    RandomStream& stream_;
};

/// Returns the scale for the target acceptance, from counts with `scale`. It is unchanged below 30
/// proposals, changes at most by a factor of two, and is at most one half.
inline float adapted(float scale, const Acceptance& counted, float target) {
    if (counted.proposed < 30) return scale;
    const float ratio =
        (static_cast<float>(counted.accepted) + 0.5F) / (static_cast<float>(counted.proposed) + 1);
    const float change = std::log(target) / std::log(ratio);
    return std::min(0.5F, scale * std::clamp(change, 0.5F, 2.0F));
}

inline MutationScales adapted(const MutationScales& scales, const Acceptances& counted,
                              float target) {
    MutationScales result;
    for (std::size_t kind = 0; kind < kMutationKinds; ++kind)
        result.scale.at(kind) = adapted(scales.scale.at(kind), counted.at(kind), target);
    return result;
}

}  // namespace sunfleck::engine
