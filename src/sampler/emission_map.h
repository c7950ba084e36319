// A map of the emission's slots: where uniform paths should start so that more of them are seen.
//
// In:  points of [0,1)^5 from which visible paths start. Out: a density over [0,1)^5, constant in
// the boxes of a tree, and a map of uniform points to points of that density, continuous in every
// slot but where boxes meet. What starts with density q counts 1/q: exact for any map that was
// fixed before the pass, as q is nowhere zero. Source: importance sampling; density trees: Ram and
// Gray 2011; guiding of light paths by what was learned: Jensen 1995.
#pragma once

#include "sampler/primary_sample.h"
#include "sampler/sobol.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck {

inline constexpr std::size_t kMappedSlots = 5;  // EmissionSlot::position_u .. light
static_assert(kMappedSlots == kSobolDimensions && slot(EmissionSlot::light) + 1 == kMappedSlots);

/// Slots in (0,1).
using EmissionPoint = std::array<double, kMappedSlots>;

struct WeightedEmission {
    EmissionPoint point{};
    double weight = 1;  // positive
};

class EmissionMap {
public:
    /// Maps every point to itself.
    EmissionMap() = default;

    /// @param points  samples of the density wanted; none: the identity.
    /// @param uniform_share  of all points that are spread evenly, in (0,1].
    static EmissionMap learned(std::vector<WeightedEmission> points, double uniform_share);

    /// What became of a path that started at a point.
    struct Trial {
        EmissionPoint point{};
        bool visible = false;
    };
    /// The same boxes, but only those in which trials were visible and often enough, and each with
    /// a density in proportion to the root of how often: what uniform paths need for the least
    /// variance. Elsewhere there are no images. None anywhere: the identity.
    /// @param least  share of visible trials.
    /// @param kept   of the images: spread as now over boxes that are denser than uniform points.
    EmissionMap where_visible(const std::vector<Trial>& trials, double least, double kept) const;

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
    /// Are there images of uniform points?
    bool covers(const EmissionPoint& at) const { return density(at) > 0; }

private:
    friend class EmissionMapBuilder;

    /// A box in two, or whole.
    struct Node {
        double at = 0;          // where it is cut: a slot's value
        double left_share = 0;  // of the box's points
        double density = 1;     // of a whole box
        double volume = 1;
        std::uint32_t left = 0;  // number of the left half, the right one's is next; 0: whole
        std::uint32_t slot = 0;  // which is cut
    };

    /// The whole box of a point. @return its number.
    std::uint32_t box_of(const EmissionPoint& at) const;
    /// Sets densities and shares by masses: of whole boxes, by number; those of others are filled.
    void set_masses(std::vector<double>& masses);

    std::vector<Node> nodes_;
};

}  // namespace sunfleck
