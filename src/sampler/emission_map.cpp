// The tree is grown from the points box by box; then a share of its mass is spread evenly.
#include "sampler/emission_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace sunfleck {
namespace {

constexpr std::size_t kBins = 8;         // places where a box may be cut, by slot
constexpr double kLeastWidth = 0x1p-32;  // of a box that is cut: slots have 52 bits
constexpr double kLeastEffective = 12;   // points in a box that is cut
constexpr double kLeastGain = 3;         // of log likelihood, in points

struct Box {
    EmissionPoint low{};
    EmissionPoint high;
};

/// Weights of points, and how many of equal weight they are worth.
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
    std::uint32_t slot = 0;
    double at = 0;
};

/// x ln(x / expected), 0 where there is nothing.
double surprise(double share, double expected) {
    return share > 0 ? share * std::log(share / expected) : 0;
}

/// The cut that tells most, in nats a point.
Cut best_cut(std::span<const WeightedEmission> points, const Box& box, const Mass& all) {
    Cut best;
    for (std::uint32_t s = 0; s < kMappedSlots; ++s) {
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
            const double part = static_cast<double>(k) / kBins;
            const double gain = surprise(left, part) + surprise(1 - left, 1 - part);
            if (gain > best.gain) best = {gain, s, box.low[s] + width * part};
        }
    }
    return best;
}

}  // namespace

/// Grows the tree, depth first.
class EmissionMapBuilder {
public:
    EmissionMapBuilder(std::vector<WeightedEmission>&& points, double uniform_share)
        : points_(std::move(points)), uniform_share_(uniform_share) {}

    EmissionMap build() {
        Box whole;
        whole.high.fill(1);
        map_.nodes_.emplace_back();
        grow(0, whole, {0, points_.size()}, 1, 1);
        if (map_.nodes_.size() == 1) map_.nodes_.clear();
        return std::move(map_);
    }

private:
    struct Range {
        std::size_t begin;
        std::size_t end;
    };

    /// @param share  of the points' mass that the box holds, by the model. @param volume  its own.
    /// @return its mass, the uniform share in it.
    double grow(std::uint32_t node, const Box& box, const Range& range, double share,
                double volume) {
        const double mass = (1 - uniform_share_) * share + uniform_share_ * volume;
        map_.nodes_[node].density = mass / volume;
        map_.nodes_[node].volume = volume;
        const std::span<WeightedEmission> points(points_.data() + range.begin,
                                                 range.end - range.begin);
        Mass all;
        for (const WeightedEmission& p : points) all.add(p.weight);
        if (all.effective() < kLeastEffective) return mass;
        const Cut cut = best_cut(points, box, all);
        if (cut.gain * all.effective() < kLeastGain) return mass;

        const auto middle = std::partition(points.begin(), points.end(), [&](const auto& p) {
            return p.point[cut.slot] < cut.at;
        });
        Mass left_mass;
        for (auto p = points.begin(); p != middle; ++p) left_mass.add(p->weight);
        Box left = box;
        Box right = box;
        left.high[cut.slot] = right.low[cut.slot] = cut.at;
        const double part = (cut.at - box.low[cut.slot]) / (box.high[cut.slot] - box.low[cut.slot]);
        // Two points more, spread evenly: no part of a box is empty for certain.
        const double n = all.effective();
        const double to_left = (left_mass.sum / all.sum * n + 2 * part) / (n + 2);
        const std::size_t split = range.begin + static_cast<std::size_t>(middle - points.begin());

        const auto first = static_cast<std::uint32_t>(map_.nodes_.size());
        map_.nodes_.resize(first + 2);
        const double in_left =
            grow(first, left, {range.begin, split}, share * to_left, volume * part);
        grow(first + 1, right, {split, range.end}, share * (1 - to_left), volume * (1 - part));
        EmissionMap::Node& cut_node = map_.nodes_[node];
        cut_node.at = cut.at;
        cut_node.slot = cut.slot;
        cut_node.left = first;
        cut_node.left_share = in_left / mass;
        return mass;
    }

    std::vector<WeightedEmission> points_;
    double uniform_share_;
    EmissionMap map_;
};

EmissionMap EmissionMap::learned(std::vector<WeightedEmission> points, double uniform_share) {
    return EmissionMapBuilder(std::move(points), uniform_share).build();
}

EmissionMap::Image EmissionMap::operator()(const EmissionPoint& uniform) const {
    Image image{uniform, 1};
    if (is_identity()) return image;
    EmissionPoint& u = image.point;  // within the box, until it is whole
    EmissionPoint low{};
    EmissionPoint high;
    high.fill(1);
    const Node* node = nodes_.data();
    for (; node->left != 0;) {
        const std::uint32_t s = node->slot;
        if (u[s] < node->left_share) {
            u[s] /= node->left_share;
            high[s] = node->at;
            node = &nodes_[node->left];
        } else {
            u[s] = (u[s] - node->left_share) / (1 - node->left_share);
            low[s] = node->at;
            node = &nodes_[node->left + 1];
        }
    }
    for (std::size_t s = 0; s < kMappedSlots; ++s) u[s] = low[s] + u[s] * (high[s] - low[s]);
    image.density = node->density;
    return image;
}

double EmissionMap::density(const EmissionPoint& at) const {
    return is_identity() ? 1 : nodes_[box_of(at)].density;
}

std::uint32_t EmissionMap::box_of(const EmissionPoint& at) const {
    std::uint32_t number = 0;
    while (nodes_[number].left != 0) {
        const Node& node = nodes_[number];
        number = node.left + (at[node.slot] < node.at ? 0 : 1);
    }
    return number;
}

EmissionMap EmissionMap::where_visible(const std::vector<Trial>& trials, double least,
                                       double kept) const {
    if (is_identity()) return {};
    std::vector<double> tried(nodes_.size());
    std::vector<double> visible(nodes_.size());
    for (const Trial& trial : trials) {
        const std::uint32_t box = box_of(trial.point);
        tried[box] += 1;
        visible[box] += trial.visible ? 1 : 0;
    }
    EmissionMap map = *this;
    std::vector<double> masses(nodes_.size());
    double all = 0;
    double dense = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].left != 0) continue;
        const double share = visible[i] / (tried[i] + 1);
        if (share > 0 && share >= least) masses[i] = std::sqrt(share) * nodes_[i].volume;
        all += masses[i];
        if (nodes_[i].density > 1) dense += nodes_[i].density * nodes_[i].volume;
    }
    if (!(all > 0)) return {};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        masses[i] *= (1 - kept) / all;
        if (nodes_[i].left == 0 && nodes_[i].density > 1)
            masses[i] += kept * nodes_[i].density * nodes_[i].volume / dense;
    }
    map.set_masses(masses);
    return map;
}

void EmissionMap::set_masses(std::vector<double>& masses) {
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // halves come after the whole
        Node& node = nodes_[i];
        node.density = masses[i] / node.volume;
        if (node.left == 0) continue;
        masses[i] = masses[node.left] + masses[node.left + 1];
        node.left_share = masses[i] > 0 ? masses[node.left] / masses[i] : 0.5;
        node.density = masses[i] / node.volume;
    }
}

}  // namespace sunfleck
