// Which light a point is lit from: by what arrives there, from bounds of clusters of lights.
//
// In:  all lights with their weights. Out: a light, and the exact probability of its choice, also
// for a light that was met. A binary tree over the lights that are somewhere: at each node a branch
// by the importance of both clusters. Lights that are infinitely far away are chosen among by
// weight, all together with a fixed share. Where few lights are somewhere, all are chosen by
// weight, for looking at them would cost more than it gains; but a lamp beside a sun that outshines
// it is not left out: the sun may not come in. One number u serves all. Source: Conty
// Estevez and Kulla (light_bounds.h); Pharr, Jakob and Humphreys, Physically Based Rendering (4th
// edition), section 12.6.3, for the walk back down to a given light.
#pragma once

#include "light/choice.h"
#include "light/light_bounds.h"

#include <cstdint>

namespace sunfleck::engine {

class LightTree {
public:
    LightTree() = default;
    /// @param weights  one a light: its power times its luminance; what is not positive and finite
    /// is never chosen.
    LightTree(const std::vector<Light>& lights, const std::vector<double>& weights);

    /// Is there more than weights: does it matter where light is wanted?
    bool is_grown() const { return !nodes_.empty(); }
    /// Nothing where no light can come from any that is chosen. @param u  in (0,1).
    std::optional<LightChoice::Chosen> choose(const Receiver& at, double u) const;
    /// As many as there are numbers, as choose() gives each; what their ways down have in common is
    /// looked at once.
    /// @param u  ascending, in (0,1); is changed. @param chosen  as many, without a value.
    void choose_each(const Receiver& at, std::span<double> u,
                     std::span<std::optional<LightChoice::Chosen>> chosen) const;
    /// With which choose() gives `index`, for u uniform in (0,1).
    double probability(const Receiver& at, std::size_t index) const;

private:
    struct Node {
        LightCluster cluster;
        std::uint32_t right = 0;  // of an inner node, whose left child comes next; else 0
        std::uint32_t light = 0;  // of a leaf
    };
    /// The turns from the root to a light, the first in the lowest bit; one: right.
    struct Way {
        std::uint64_t turns = 0;
        std::uint32_t length = kNone;  // none: the light is not in the tree
    };
    struct Item {
        LightBounds bounds;
        std::uint32_t light = 0;
    };

    void build(std::span<Item> items, Way way);
    /// From a node down. @param probability  of coming there.
    void walk_down(std::uint32_t node, double probability, const Receiver& at, std::span<double> u,
                   std::span<std::optional<LightChoice::Chosen>> chosen) const;
    /// The probability of going left, or none where nothing comes from either side.
    std::optional<double> left_share(std::uint32_t node, const Receiver& at) const;

    std::vector<Node> nodes_;
    std::vector<Way> ways_;  // by light
    LightChoice by_weight_;  // those that are not in the tree
    double weight_share_ = 0;
};

}  // namespace sunfleck::engine
