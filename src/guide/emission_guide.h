// EmissionGuide: a learned density over the emission dimensions that makes more paths visible (path
// guiding).
//
// In:  points of [0,1)^5 from which visible paths start. Out: a density over [0,1)^5, constant in
// the boxes of a tree, and a map from uniform points to points of that density, continuous in every
// dimension except between boxes. Boxes may be sheared, dimension by dimension, on the way down the
// tree. Two guides make a mixture, which keeps what either knows. A path that starts with density q
// has the weight 1/q: unbiased for any density fixed before the pass, since q is nowhere zero.
// Source: importance sampling; density trees: Ram and Gray 2011; guiding of photon paths: Jensen
// 1995.
// Equations: docs/method/sampling.md, eq. (15).
#pragma once

#include "guide/emission_shear.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace sunfleck::engine {

class EmissionGuide {
public:
    /// Makes the identity.
    EmissionGuide() = default;

    struct Growth {
        double uniform_share = 0.25;  // of the density: a defensive mixture, in (0,1]
        double least_gain = 8;        // in log likelihood, of a cut: 35 are tried
        double spread = 0;            // of the mass of each inner box: uniform over it
    };

    /// @param points  samples of the wanted density; none gives the identity.
    static EmissionGuide learned(std::vector<WeightedEmission> points, const Growth& growth);

    /// The result of a path that started at a point.
    struct Trial {
        EmissionPoint point{};
        bool visible = false;
    };
    /// Returns the boxes in which trials were visible often enough, each with a density
    /// proportional to the square root of the visible fraction, which minimises the variance of
    /// uniform paths. Elsewhere there are no images. If there are none anywhere: the identity.
    /// @param least  visible fraction, positive.
    EmissionGuide where_visible(const std::vector<Trial>& trials, double least) const;

    /// Returns the same boxes with densities proportional to the square root of what was found
    /// there, the best for boxes that points fill to an unknown small part. Where uniform points
    /// are as dense there are no images. If there are none anywhere: the identity.
    /// @param kept  fraction of the images, in [0,1], with the present density.
    EmissionGuide widened(double kept) const;

    /// What a trial was worth to the picture.
    struct Worth {
        EmissionPoint point{};
        double square = 0;  // of its worth, over the sum of the densities of all trials there
    };
    /// Returns the same boxes with densities in proportion to the root of the mean squared worth of
    /// a path from there, which minimises the variance of independent paths. Few trials of a box
    /// count less than those of the box around it.
    /// @param kept  share of the mass that follows the points that the boxes were learned from.
    /// @param growth  the one by which they were learned.
    EmissionGuide by_worth(const std::vector<Worth>& trials, double kept,
                           const Growth& growth) const;

    /// Returns the mixture of this density and another. Made last: boxes and their masses are those
    /// of this guide alone.
    /// @param share  of the other, in (0,1).
    EmissionGuide mixed_with(std::shared_ptr<const EmissionGuide> other, double share) const;

    struct Image {
        EmissionPoint point;
        double density = 1;  // at the point, over [0,1)^5
    };

    /// @param uniform  in (0,1)^5.
    Image operator()(const EmissionPoint& uniform) const;
    /// Returns the density of the images of uniform points: zero where there are none.
    double density(const EmissionPoint& at) const;

    bool is_identity() const { return nodes_.empty() && !other_; }
    std::size_t boxes() const { return nodes_.size() / 2 + 1; }
    std::size_t shears() const { return shears_.size(); }
    /// Returns whether uniform points have images there.
    bool covers(const EmissionPoint& at) const { return density(at) > 0; }

private:
    friend class EmissionGuideBuilder;

    /// A box, cut in two or a leaf, after its shears.
    struct Node {
        double at = 0;          // coordinate of the cut
        double left_share = 0;  // of the box's points
        double density = 1;     // of a leaf
        double volume = 1;
        double found = 0;             // fraction of the points that it was learned from
        std::uint32_t left = 0;       // index of the left half, the right one is next; 0 for a leaf
        std::uint32_t dimension = 0;  // dimension of the cut
        std::uint32_t first_shear = 0;
        std::uint32_t shears = 0;
    };

    Image image_in_tree(const EmissionPoint& uniform) const;
    double density_of_tree(const EmissionPoint& at) const;
    /// Returns the leaf of a point.
    std::uint32_t box_of(EmissionPoint at) const;
    /// Returns the same boxes with masses proportional to these: of leaves, by index; those of
    /// inner nodes are filled in. All zero: the identity.
    /// @param spread  of the mass of each inner box is spread over it.
    EmissionGuide with_masses(std::vector<double> masses, double spread = 0) const;

    /// Spreads a share of the mass of each inner box evenly over it: density falls by degrees from
    /// where much was found to where nothing was, and a hole that a cut left by chance stays within
    /// reach.
    void spread_masses(double share);
    /// Returns the mean squared worth in each box, halves drawn towards their whole.
    std::vector<double> mean_squares(const std::vector<Worth>& trials) const;

    std::vector<Node> nodes_;
    std::vector<EmissionShear> shears_;
    std::shared_ptr<const EmissionGuide> other_;  // of the mixture, if it is one
    double share_of_other_ = 0;
};

}  // namespace sunfleck::engine
