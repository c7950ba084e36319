// Coats of plastic and varnish: one for all materials that ask for the same.
#pragma once

#include "bsdf/coat.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace sunfleck::engine {

class GltfCoats {
public:
    /// Returns a clear coat. @param facets  of a rough one; none if it is smooth.
    std::shared_ptr<const Coat> of(double ior, const std::optional<Ggx>& facets) {
        const auto index = static_cast<float>(ior);
        const Ggx widths = facets.value_or(Ggx{0, 0});
        std::shared_ptr<const Coat>& coat = coats_[{index, widths.alpha_x, widths.alpha_y}];
        if (!coat) coat = std::make_shared<const Coat>(index, facets, 0.0F);
        return coat;
    }

private:
    std::map<std::tuple<float, float, float>, std::shared_ptr<const Coat>> coats_;  // index, alphas
};

}  // namespace sunfleck::engine
