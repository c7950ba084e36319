// A shear of a box of emission points: one dimension moves by a linear function of the others, so
// that a slanted tube of points stands upright and boxes fit it.
//
// In:  points of a box [low, high)^5. Out: points of the same box; what leaves it at one side comes
// in at the other. Volumes stay as they are, so densities do, too. Only + - * /, and floor.
#pragma once

#include "random_numbers/emission_point.h"

#include <cmath>
#include <optional>
#include <span>

namespace sunfleck::engine {

struct EmissionBox {
    EmissionPoint low{};
    EmissionPoint high{1, 1, 1, 1, 1};
};

struct EmissionShear {
    std::size_t dimension = 0;  // that moves
    double low = 0;             // of the box in that dimension
    double width = 1;
    EmissionPoint slope{};   // of the dimension's mean in each of the others; its own is zero
    EmissionPoint centre{};  // where it moves by nothing

    void apply(EmissionPoint& p) const { p[dimension] = wrapped(p[dimension] - shift(p)); }
    /// The inverse of apply(), but for the last bit.
    void undo(EmissionPoint& p) const { p[dimension] = wrapped(p[dimension] + shift(p)); }

private:
    double shift(const EmissionPoint& p) const {
        double sum = 0;
        for (std::size_t s = 0; s < kGuidedDimensions; ++s) sum += slope[s] * (p[s] - centre[s]);
        return sum;
    }
    double wrapped(double x) const { return x - width * std::floor((x - low) / width); }
};

struct FoundShear {
    EmissionShear shear;
    double gain = 0;  // in nats a point, were the points normally distributed
};

/// The shear that makes a dimension vary least, by linear regression on all others. Nothing where
/// the points do not vary.
/// @param points  of the box.
FoundShear best_shear(std::span<const WeightedEmission> points, const EmissionBox& box);

}  // namespace sunfleck::engine
