// Choice of a light: running sums and a binary search.
#include "light/choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sunfleck::engine {

LightChoice::LightChoice(const std::vector<double>& powers) {
    cdf_.reserve(powers.size() + 1);
    for (const double power : powers) {
        if (power > 0 && std::isfinite(power)) total_ += power;
        cdf_.push_back(total_);
    }
    if (!(total_ > 0)) return;
    // The last sum over itself is exactly one, so no u below one falls off the end.
    for (double& sum : cdf_) sum /= total_;
}

LightChoice LightChoice::among(const std::vector<std::uint32_t>& lights) const {
    std::vector<double> powers(cdf_.size() - 1, 0.0);
    for (const std::uint32_t light : lights) powers[light] = probability(light) * total_;
    return LightChoice(powers);
}

LightChoice::Chosen LightChoice::choose(double u) const {
    assert(!empty());
    // The first end beyond u: lights of no power end where they start and are passed over.
    const auto end = std::upper_bound(cdf_.begin() + 1, cdf_.end(), u);
    const auto index = static_cast<std::size_t>(end - cdf_.begin()) - 1;
    return {index, probability(index)};
}

}  // namespace sunfleck::engine
