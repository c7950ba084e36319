// Which light a photon path starts from: by power, by inverting the CDF in the list's order.
//
// Neighbours in the list stay neighbours in the dimension, so that a small move of it changes to a
// light nearby (an alias table would not).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class LightChoice {
public:
    struct Chosen {
        std::size_t index = 0;
        double probability = 0;  // with which choose() gives this index
    };

    LightChoice() = default;
    /// @param powers  one a light, same unit; what is not positive and finite is never chosen.
    explicit LightChoice(const std::vector<double>& powers);

    /// The same odds among some of the lights, and none for the others.
    LightChoice among(const std::vector<std::uint32_t>& lights) const;

    /// Is there nothing to choose (no lights, or none with power)?
    bool empty() const { return !(cdf_.back() > 0); }
    /// @param u  in (0,1). Not to be asked of an empty choice.
    Chosen choose(double u) const;
    /// A number for which choose() gives `index`. @param along  in [0,1): of all such numbers.
    double number(std::size_t index, double along) const {
        return cdf_[index] + along * probability(index);
    }
    /// With which choose() gives `index`, for u uniform in (0,1).
    double probability(std::size_t index) const { return cdf_[index + 1] - cdf_[index]; }
    /// Sum of the powers.
    double total() const { return total_; }

private:
    std::vector<double> cdf_{0};  // one more than lights; ends in one, or in zero when empty
    double total_ = 0;
};

}  // namespace sunfleck::engine
