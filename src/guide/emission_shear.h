// EmissionShear: a shear of a box of emission points, which makes a slanted tube of points upright
// so that boxes fit it.
//
// In:  points of a box [low, high)^5. Out: points of the same box, with wrap-around. A dimension
// moves by a linear function of the others. Volumes and densities are unchanged. Only + - * / and
// floor are used.
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
    std::size_t dimension = 0;  // the dimension that moves
    double low = 0;             // of the box in that dimension
    double width = 1;
    EmissionPoint slope{};   // of the dimension's mean in each other dimension; its own is zero
    EmissionPoint centre{};  // point without displacement

    void apply(EmissionPoint& p) const { p[dimension] = wrapped(p[dimension] - shift(p)); }
    /// Inverts apply(), up to the last bit.
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
    double gain = 0;  // in nats per point, if points were normally distributed
};

/// Returns the shear that minimises the variance of a dimension, by linear regression on all
/// others. Nothing if the points do not vary.
/// @param points  of the box.
FoundShear best_shear(std::span<const WeightedEmission> points, const EmissionBox& box);

}  // namespace sunfleck::engine
