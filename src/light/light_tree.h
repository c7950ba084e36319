// LightTree: selects the light for a receiver by estimated contribution, from bounds of clusters.
//
// In:  all lights with their weights. Out: a light and the exact probability of its selection, also
// for a given light (MIS).
// A binary tree holds the lights at finite distance; each node branches by the importance of both
// clusters. Infinitely distant lights are selected by weight, and all together have a fixed
// probability. If only a few lights are at finite distance, all lights are selected by weight,
// because evaluation of their importance would cost more than it gains. But a lamp beside a sun
// that outshines it keeps a minimum probability, since the sun may be occluded. One number u is
// enough for the whole descent.
// Source: Conty Estevez and Kulla (light_bounds.h); Pharr, Jakob and Humphreys, Physically Based
// Rendering (4th edition), section 12.6.3, for the descent to a given light.
#pragma once

#include "light/choice.h"
#include "light/light_bounds.h"

#include <cstdint>

namespace sunfleck::engine {

class LightTree {
public:
    LightTree() = default;
    /// @param weights  one per light: power times luminance of the spectrum; values that are not
    /// positive and finite are never chosen.
    LightTree(const std::vector<Light>& lights, const std::vector<double>& weights);

    /// Returns whether the selection depends on the receiver (there is a tree).
    bool is_grown() const { return !nodes_.empty(); }
    /// Selects a light; nothing if no light can arrive from any. @param u  in (0,1).
    std::optional<LightChoice::Chosen> choose(const Receiver& at, double u) const;
    /// Selects a light for each number, as choose() does, and evaluates common nodes once.
    /// @param u  ascending, in (0,1); modified.
    /// @param chosen  as many as numbers, initially without a value.
    void choose_each(const Receiver& at, std::span<double> u,
                     std::span<std::optional<LightChoice::Chosen>> chosen) const;
    /// Returns the probability with which choose() returns `index`, for u uniform in (0,1).
    double probability(const Receiver& at, std::size_t index) const;

private:
    struct Node {
        LightCluster cluster;
        std::uint32_t right = 0;  // of an inner node, whose left child is next in the list; else 0
        std::uint32_t light = 0;  // of a leaf
    };
    /// The branches from the root to a light, the first in the lowest bit; a one means right.
    struct Way {
        std::uint64_t branches = 0;
        std::uint32_t length = kNone;  // kNone if the light is not in the tree
    };
    struct Item {
        LightBounds bounds;
        std::uint32_t light = 0;
    };

    void build(std::span<Item> items, Way way);
    /// Descends from a node. @param probability  of reaching it.
    void walk_down(std::uint32_t node, double probability, const Receiver& at, std::span<double> u,
                   std::span<std::optional<LightChoice::Chosen>> chosen) const;
    /// Returns the probability of the left branch, or none if both importances are zero.
    std::optional<double> left_share(std::uint32_t node, const Receiver& at) const;

    std::vector<Node> nodes_;
    std::vector<Way> ways_;  // per light
    LightChoice by_weight_;  // the lights that are not in the tree
    double weight_share_ = 0;
};

}  // namespace sunfleck::engine
