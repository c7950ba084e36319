// The emission guide: a learned density over emission dimensions, by which more paths are visible.
//
// In:  points of [0,1)^5 from which visible paths start. Out: a density over [0,1)^5, constant in
// the boxes of a tree, and a map from uniform points to points of that density, continuous in every
// dimension but where boxes meet. Boxes may be sheared, dimension by dimension, on the way down the
// tree. What starts with density q counts 1/q: exact for any density that was fixed before the
// pass, as q is nowhere zero. Source: importance sampling; density trees: Ram and Gray 2011;
// guiding of light paths by what was learned: Jensen 1995.
#pragma once

#include "guide/emission_shear.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class EmissionGuide {
public:
    /// Maps every point to itself.
    EmissionGuide() = default;

    struct Growth {
        double uniform_share = 0.25;  // of all points that are spread evenly, in (0,1]
        double least_gain = 8;        // in log likelihood, of a cut: there are 35 to try
    };

    /// @param points  samples of the density wanted; none: the identity.
    static EmissionGuide learned(std::vector<WeightedEmission> points, const Growth& growth);

    /// What became of a path that started at a point.
    struct Trial {
        EmissionPoint point{};
        bool visible = false;
    };
    /// The same boxes, but only those in which trials were visible and often enough, and each with
    /// a density in proportion to the root of how often: what uniform paths need for the least
    /// variance. Elsewhere there are no images. None anywhere: the identity.
    /// @param least  share of visible trials, positive.
    EmissionGuide where_visible(const std::vector<Trial>& trials, double least) const;

    /// The same boxes with densities in proportion to the root of what was found there, the best
    /// for boxes of which points fill an unknown small part. Where uniform points are as dense
    /// there are no images. None anywhere: the identity.
    /// @param kept  of the images, in [0,1]: spread as now.
    EmissionGuide widened(double kept) const;

    struct Image {
        EmissionPoint point;
        double density = 1;  // there, over [0,1)^5
    };

    /// @param uniform  in (0,1)^5.
    Image operator()(const EmissionPoint& uniform) const;
    /// Of the images of uniform points: zero where there are none.
    double density(const EmissionPoint& at) const;

    bool is_identity() const { return nodes_.empty(); }
    std::size_t boxes() const { return nodes_.size() / 2 + 1; }
    std::size_t shears() const { return shears_.size(); }
    /// Are there images of uniform points?
    bool covers(const EmissionPoint& at) const { return density(at) > 0; }

private:
    friend class EmissionGuideBuilder;
    static constexpr std::size_t kMostShears = 8;  // on the way to a box

    /// A box in two, or whole; sheared before that.
    struct Node {
        double at = 0;          // where it is cut: a dimension's value
        double left_share = 0;  // of the box's points
        double density = 1;     // of a whole box
        double volume = 1;
        double found = 0;             // share of the points that it was learned from
        std::uint32_t left = 0;       // number of the left half, the right one's is next; 0: whole
        std::uint32_t dimension = 0;  // which is cut
        std::uint32_t first_shear = 0;
        std::uint32_t shears = 0;
    };

    /// The whole box of a point. @return its number.
    std::uint32_t box_of(EmissionPoint at) const;
    /// The same boxes with other masses in proportion to these: of whole boxes, by number; those of
    /// others are filled. All zero: the identity.
    EmissionGuide with_masses(std::vector<double> masses) const;

    std::vector<Node> nodes_;
    std::vector<EmissionShear> shears_;
};

}  // namespace sunfleck::engine
