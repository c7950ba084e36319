// Growth of the tree from points, box by box; then a fraction of its mass is spread uniformly.
// Where a shear gains more likelihood than any cut, as in a slanted tube, the box is sheared first.
#include "guide/emission_guide.h"
#include "guide/growth_tuning.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace sunfleck::engine {
namespace {

/// Weights of points, and their effective number.
struct Mass {
    double sum = 0;
    double squares = 0;
    void add(double weight) {
        sum += weight;
        squares += weight * weight;
    }
    void add(const Mass& other) {
        sum += other.sum;
        squares += other.squares;
    }
    double effective() const { return squares > 0 ? sum * sum / squares : 0; }
};

struct Cut {
    double gain = 0;
    std::uint32_t dimension = 0;
    double at = 0;
};

/// Returns x ln(x / expected), 0 for zero. It uses the float function, whose bits are the same on
/// every machine.
double surprise(double share, double expected) {
    return share > 0 ? share * std::log(static_cast<float>(share / expected)) : 0;
}

/// Returns the cut with the largest gain, in nats per point.
Cut best_cut(std::span<const WeightedEmission> points, const EmissionBox& box, const Mass& all) {
    Cut best;
    for (std::uint32_t s = 0; s < kGuidedDimensions; ++s) {
        std::array<double, kBins> bins{};
        const double width = box.high[s] - box.low[s];
        if (width < kLeastWidth) continue;
        for (const WeightedEmission& p : points) {
            const double place = (p.point[s] - box.low[s]) / width * kBins;
            bins.at(std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, place)))) +=
                p.weight;
        }
        double left = 0;
        for (std::size_t k = 1; k < kBins; ++k) {
            left += bins.at(k - 1) / all.sum;
            const double fraction = static_cast<double>(k) / kBins;
            const double gain = surprise(left, fraction) + surprise(1 - left, 1 - fraction);
            if (gain > best.gain) best = {gain, s, box.low[s] + width * fraction};
        }
    }
    return best;
}

}  // namespace

/// Grows the tree, depth first.
class EmissionGuideBuilder {
public:
    EmissionGuideBuilder(std::vector<WeightedEmission>&& points,
                         const EmissionGuide::Growth& growth)
        : points_(std::move(points)), growth_(growth) {
        for (const WeightedEmission& p : points_) all_points_ += p.weight;
    }

    EmissionGuide build() {
        guide_.nodes_.emplace_back();
        grow(0, {{}, {0, points_.size()}, 1, 1, 0});
        if (guide_.nodes_.size() == 1) guide_.nodes_.clear();
        return std::move(guide_);
    }

private:
    struct Range {
        std::size_t begin;
        std::size_t end;
    };

    struct Region {
        EmissionBox box;
        Range range;         // of its points
        double share;        // of the points' mass, by the model
        double volume;       // of the box
        std::size_t shears;  // on the way to it
    };

    /// @return the mass of the box, uniform part included.
    double grow(std::uint32_t node, const Region& region) {
        const double even = growth_.uniform_share;
        const double mass = (1 - even) * region.share + even * region.volume;
        guide_.nodes_[node].density = mass / region.volume;
        guide_.nodes_[node].volume = region.volume;
        const std::span<WeightedEmission> points(points_.data() + region.range.begin,
                                                 region.range.end - region.range.begin);
        Mass all;
        for (const WeightedEmission& p : points) all.add(p.weight);
        guide_.nodes_[node].found = all.sum / all_points_;
        if (all.effective() < kLeastEffective) return mass;
        Cut cut = best_cut(points, region.box, all);
        const std::size_t shears = region.shears + shear(node, points, region, all, cut);
        if (cut.gain * all.effective() < growth_.least_gain) {
            guide_.shears_.resize(guide_.nodes_[node].first_shear);  // they had no use
            guide_.nodes_[node].shears = 0;
            return mass;
        }
        const auto middle = std::partition(points.begin(), points.end(), [&](const auto& p) {
            return p.point[cut.dimension] < cut.at;
        });
        Mass left;
        for (auto p = points.begin(); p != middle; ++p) left.add(p->weight);
        const std::size_t split =
            region.range.begin + static_cast<std::size_t>(middle - points.begin());
        return divide(node, region, cut,
                      {split, shears, left.sum / all.sum, all.effective(), mass});
    }

    struct Division {
        std::size_t split;   // index of the first point of the right half
        std::size_t shears;  // on the way to both
        double in_left;      // of the points' weight
        double points;       // effective number of all
        double mass;         // of both
    };

    double divide(std::uint32_t node, const Region& region, const Cut& cut, const Division& d) {
        Region left = region;
        Region right = region;
        left.shears = right.shears = d.shears;
        left.box.high[cut.dimension] = right.box.low[cut.dimension] = cut.at;
        left.range.end = right.range.begin = d.split;
        const double volume = (cut.at - region.box.low[cut.dimension]) /
                              (region.box.high[cut.dimension] - region.box.low[cut.dimension]);
        // Two more points, spread uniformly, so that no part of a box is certainly empty.
        const double found_left = (d.in_left * d.points + 2 * volume) / (d.points + 2);
        const double to_left = (1 - growth_.spread) * found_left + growth_.spread * volume;
        left.share *= to_left;
        right.share *= 1 - to_left;
        left.volume *= volume;
        right.volume *= 1 - volume;

        const auto first = static_cast<std::uint32_t>(guide_.nodes_.size());
        guide_.nodes_.resize(first + 2);
        const double in_left = grow(first, left);
        grow(first + 1, right);
        EmissionGuide::Node& cut_node = guide_.nodes_[node];
        cut_node.at = cut.at;
        cut_node.dimension = cut.dimension;
        cut_node.left = first;
        cut_node.left_share = in_left / d.mass;
        return d.mass;
    }

    /// Shears the box and its points while that gains more than a cut. @return number of shears.
    /// @param cut  the best cut, before and after.
    std::size_t shear(std::uint32_t node, std::span<WeightedEmission> points, const Region& region,
                      const Mass& all, Cut& cut) {
        guide_.nodes_[node].first_shear = static_cast<std::uint32_t>(guide_.shears_.size());
        if (all.effective() < kLeastToShear) return 0;
        std::size_t count = 0;
        while (region.shears + count < kMostShears) {
            const FoundShear found = best_shear(points, region.box);
            if (found.gain < kLeastShear || found.gain < cut.gain) break;
            for (WeightedEmission& p : points) found.shear.apply(p.point);
            cut = best_cut(points, region.box, all);
            guide_.shears_.push_back(found.shear);
            ++count;
        }
        guide_.nodes_[node].shears = static_cast<std::uint32_t>(count);
        return count;
    }

    std::vector<WeightedEmission> points_;
    EmissionGuide::Growth growth_;
    double all_points_ = 0;  // sum of weights
    EmissionGuide guide_;
};

EmissionGuide EmissionGuide::learned(std::vector<WeightedEmission> points, const Growth& growth) {
    return EmissionGuideBuilder(std::move(points), growth).build();
}

}  // namespace sunfleck::engine
