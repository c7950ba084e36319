// Building the tree top down, and walking down it.
#include "light/light_tree.h"

#include <algorithm>
#include <limits>

namespace sunfleck::engine {
namespace {

/// So many lights that are somewhere (two square lamps) are chosen by weight, where far lights do
/// not leave them too little.
constexpr std::size_t kFew = 4;
constexpr int kBuckets = 12;
/// Larger sets are halved along their longest side: there the measure tells little.
constexpr std::size_t kMostMeasured = 1 << 16;
/// Deeper down sets are halved, so that the turns to any light fit into 64 bits.
constexpr std::uint32_t kDeepestMeasured = 32;
/// The share of far lights, beside near ones, stays in between, whatever their power.
constexpr double kLeastShare = 0.25;

struct Split {
    int axis = 0;
    double at = 0;  // centres below go left
    double cost = std::numeric_limits<double>::infinity();
};

Bounds centers_of(const auto& items) {
    Bounds box;
    for (const auto& item : items) box.extend(item.bounds.box.center());
    return box;
}

void add(std::optional<LightBounds>& sum, const LightBounds& more) {
    sum = sum ? merged(std::array{*sum, more}) : more;
}

/// The best of the planes between buckets along one axis.
Split best_plane(const auto& items, const Bounds& centers, int axis) {
    const double low = centers.min[axis];
    const double width = (centers.max[axis] - low) / kBuckets;
    std::array<std::optional<LightBounds>, kBuckets> buckets;
    for (const auto& item : items) {
        const double place = (item.bounds.box.center()[axis] - low) / width;
        const int bucket = std::clamp(static_cast<int>(place), 0, kBuckets - 1);
        add(buckets.at(static_cast<std::size_t>(bucket)), item.bounds);
    }
    std::array<double, kBuckets> right_cost{};
    std::optional<LightBounds> sum;
    for (std::size_t i = kBuckets; i-- > 1;) {
        if (buckets.at(i)) add(sum, *buckets.at(i));
        right_cost.at(i) = sum ? measure_of(*sum) : 0;
    }
    Split best;
    best.axis = axis;
    sum.reset();
    for (std::size_t i = 1; i < kBuckets; ++i) {
        if (buckets.at(i - 1)) add(sum, *buckets.at(i - 1));
        const double cost = (sum ? measure_of(*sum) : 0) + right_cost.at(i);
        if (cost < best.cost) best = {axis, low + width * static_cast<double>(i), cost};
    }
    return best;
}

/// How many items go left after reordering: at least one, and not all.
template <class Items>
std::size_t split(Items items, std::uint32_t depth) {
    const Bounds centers = centers_of(items);
    const Vec3d size = centers.max - centers.min;
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const std::size_t half = items.size() / 2;
    if (!(size[longest] > 0)) return half;
    if (items.size() > 2 && items.size() <= kMostMeasured && depth < kDeepestMeasured) {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 0)) continue;
            Split plane = best_plane(items, centers, axis);
            plane.cost *= size[longest] / size[axis];  // thin slices are no clusters
            if (plane.cost < best.cost) best = plane;
        }
        const auto middle = std::stable_partition(items.begin(), items.end(), [&](const auto& i) {
            return i.bounds.box.center()[best.axis] < best.at;
        });
        const auto count = static_cast<std::size_t>(middle - items.begin());
        if (count > 0 && count < items.size()) return count;
    }
    std::stable_sort(items.begin(), items.end(), [&](const auto& a, const auto& b) {
        return a.bounds.box.center()[longest] < b.bounds.box.center()[longest];
    });
    return half;
}

/// How many of ascending numbers are below a share.
std::size_t below(std::span<const double> u, double share) {
    std::size_t count = 0;
    while (count < u.size() && u[count] < share) ++count;
    return count;
}

}  // namespace

LightTree::LightTree(const std::vector<Light>& lights, const std::vector<double>& weights)
    : ways_(lights.size()) {
    std::vector<Item> items;
    std::vector<double> far(lights.size(), 0.0);
    double near = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!(weights[i] > 0) || !std::isfinite(weights[i])) continue;
        if (const auto bounds = bounds_of(lights[i], weights[i])) {
            items.push_back({*bounds, static_cast<std::uint32_t>(i)});
            near += weights[i];
        } else {
            far[i] = weights[i];
        }
    }
    by_weight_ = LightChoice(far);
    const double share = by_weight_.total() / (by_weight_.total() + near);
    const bool is_fair =
        items.empty() || by_weight_.empty() || (share >= kLeastShare && share <= 1 - kLeastShare);
    if (items.size() <= kFew && is_fair) {
        by_weight_ = LightChoice(weights);
        weight_share_ = 1;
        return;
    }
    nodes_.reserve(2 * items.size());
    build(items, {0, 0});
    if (!by_weight_.empty()) weight_share_ = std::clamp(share, kLeastShare, 1 - kLeastShare);
}

void LightTree::build(std::span<Item> items, Way way) {
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    if (items.size() == 1) {
        nodes_[index] = {LightCluster(items[0].bounds), 0, items[0].light};
        ways_[items[0].light] = way;
        return;
    }
    std::vector<LightBounds> parts;
    parts.reserve(items.size());
    for (const Item& item : items) parts.push_back(item.bounds);
    nodes_[index].cluster = LightCluster(merged(parts));
    parts = {};
    const std::size_t left = split(items, way.length);
    build(items.first(left), {way.turns, way.length + 1});
    nodes_[index].right = static_cast<std::uint32_t>(nodes_.size());
    build(items.subspan(left), {way.turns | std::uint64_t{1} << way.length, way.length + 1});
}

std::optional<double> LightTree::left_share(std::uint32_t node, const Receiver& at) const {
    const double left = nodes_[node + 1].cluster.importance(at);
    const double right = nodes_[nodes_[node].right].cluster.importance(at);
    const double sum = left + right;
    if (!(sum > 0)) return {};
    return left / sum;
}

std::optional<LightChoice::Chosen> LightTree::choose(const Receiver& at, double u) const {
    std::optional<LightChoice::Chosen> chosen;
    choose_each(at, {&u, 1}, {&chosen, 1});
    return chosen;
}

void LightTree::choose_each(const Receiver& at, std::span<double> u,
                            std::span<std::optional<LightChoice::Chosen>> chosen) const {
    const std::size_t by_weight = below(u, weight_share_);
    for (std::size_t i = 0; i < by_weight && !by_weight_.empty(); ++i) {
        chosen[i] = by_weight_.choose(u[i] / weight_share_);
        chosen[i]->probability *= weight_share_;
    }
    if (nodes_.empty()) return;
    const std::span<double> rest = u.subspan(by_weight);
    for (double& v : rest) v = (v - weight_share_) / (1 - weight_share_);
    walk_down(0, 1 - weight_share_, at, rest, chosen.subspan(by_weight));
}

void LightTree::walk_down(std::uint32_t node, double probability, const Receiver& at,
                          std::span<double> u,
                          std::span<std::optional<LightChoice::Chosen>> chosen) const {
    if (u.empty()) return;
    if (nodes_[node].right == 0) {
        if (!(probability > 0)) return;
        for (auto& one : chosen) one = {nodes_[node].light, probability};
        return;
    }
    const auto share = left_share(node, at);
    if (!share) return;
    const std::size_t left = below(u, *share);
    for (double& v : u.first(left)) v /= *share;
    for (double& v : u.subspan(left)) v = (v - *share) / (1 - *share);
    walk_down(node + 1, probability * *share, at, u.first(left), chosen.first(left));
    walk_down(nodes_[node].right, probability * (1 - *share), at, u.subspan(left),
              chosen.subspan(left));
}

double LightTree::probability(const Receiver& at, std::size_t index) const {
    const Way& way = ways_[index];
    if (way.length == kNone) return by_weight_.probability(index) * weight_share_;
    double probability = 1 - weight_share_;
    std::uint32_t node = 0;
    for (std::uint32_t i = 0; i < way.length; ++i) {
        const auto share = left_share(node, at);
        if (!share) return 0;
        const bool right = (way.turns >> i & 1) != 0;
        probability *= right ? 1 - *share : *share;
        node = right ? nodes_[node].right : node + 1;
    }
    return probability;
}

}  // namespace sunfleck::engine
