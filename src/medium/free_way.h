// FreeWay: a free path on a way, by distances; FreePath knows the amounts of medium on it.
//
// Equations: docs/method/media-fields.md.
#pragma once

#include "medium/free_path.h"

#include <algorithm>

namespace sunfleck::engine {

class FreeWay {
public:
    /// The medium must outlive this. @param carried  as FreePath takes it.
    FreeWay(const SampledMedium& medium, const Ray& way, const SampledSpectrum& carried)
        : medium_(medium), way_(way), path_(medium, carried), whole_(amount(medium, way)) {}

    /// Returns the chance to be scattered on the way.
    float chance() const { return path_.chance(whole_); }
    /// Returns the chance to be scattered between two distances.
    float chance_between(float from, float to) const {
        if (!medium_.density) return path_.chance_between(from, to);
        const float before = amount_to(from);
        return path_.chance_between(before, before + amount(medium_, part_of(way_, from, to)));
    }
    /// Returns the density of being scattered there, per unit of distance.
    float density(float distance) const {
        return path_.density(amount_to(distance)) *
               density_at(medium_, way_.origin + way_.direction * distance);
    }
    /// Inverts the chance to be scattered before a distance. @param chance  in [0, chance()).
    float distance_at(float chance) const {
        return sunfleck::engine::distance_at(medium_, way_,
                                             std::min(path_.distance_at(chance), whole_));
    }
    /// Returns the factor of light that is scattered at a distance, one over the density of it
    /// included.
    SampledSpectrum scattered(float distance) const { return path_.scattered(amount_to(distance)); }

private:
    static Ray part_of(const Ray& way, float begin, float end) {
        return {way.origin + way.direction * begin, way.direction, end - begin};
    }
    float amount_to(float distance) const { return amount(medium_, part_of(way_, 0, distance)); }

    const SampledMedium& medium_;
    Ray way_;
    FreePath path_;
    float whole_ = 0;  // amount on the way
};

}  // namespace sunfleck::engine
