// LightChoice: selects the light of a photon path by power, by inversion of the CDF in list order.
//
// Neighbours in the list are neighbours in the dimension, so that a small move of it leads to a
// nearby light (an alias table would not).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class LightChoice {
public:
    struct Chosen {
        std::size_t index = 0;
        double probability = 0;  // with which choose() returns this index
    };

    LightChoice() = default;
    /// @param powers  one per light, in one unit; values that are not positive and finite are never
    /// chosen.
    explicit LightChoice(const std::vector<double>& powers);

    /// Returns a choice with the same odds among some of the lights, and zero for the others.
    LightChoice among(const std::vector<std::uint32_t>& lights) const;

    /// Returns whether there is nothing to choose (no lights, or none with power).
    bool empty() const { return !(cdf_.back() > 0); }
    /// Selects a light; the choice must not be empty. @param u  in (0,1).
    Chosen choose(double u) const;
    /// Returns a number for which choose() returns `index`. @param along  position in [0,1) among
    /// all such numbers.
    double number(std::size_t index, double along) const {
        return cdf_[index] + along * probability(index);
    }
    /// Returns the probability with which choose() returns `index`, for u uniform in (0,1).
    double probability(std::size_t index) const { return cdf_[index + 1] - cdf_[index]; }
    /// Returns the sum of the powers.
    double total() const { return total_; }

private:
    std::vector<double> cdf_{0};  // one more than lights; ends in one, or in zero if empty
    double total_ = 0;
};

}  // namespace sunfleck::engine
