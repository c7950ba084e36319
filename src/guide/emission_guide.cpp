// Evaluation of the tree: images and densities; changed masses of its boxes.
#include "guide/emission_guide.h"

#include "guide/growth_tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {

EmissionGuide EmissionGuide::mixed_with(std::shared_ptr<const EmissionGuide> other,
                                        double share) const {
    EmissionGuide mixture = *this;
    mixture.other_ = std::move(other);
    mixture.share_of_other_ = share;
    return mixture;
}

EmissionGuide::Image EmissionGuide::operator()(const EmissionPoint& uniform) const {
    if (!other_) return image_in_tree(uniform);
    // The first dimension chooses one of the two, and is uniform again for that one.
    EmissionPoint u = uniform;
    const double share = share_of_other_;
    const bool is_of_other = u[0] < share;
    u[0] = is_of_other ? u[0] / share : (u[0] - share) / (1 - share);
    Image image = is_of_other ? (*other_)(u) : image_in_tree(u);
    image.density = density(image.point);
    return image;
}

EmissionGuide::Image EmissionGuide::image_in_tree(const EmissionPoint& uniform) const {
    Image image{uniform, 1};
    if (nodes_.empty()) return image;
    EmissionPoint& u = image.point;  // within the box, until it is a leaf
    EmissionBox box;
    std::array<const EmissionShear*, kMostShears> sheared{};
    std::size_t shears = 0;
    const Node* node = nodes_.data();
    while (true) {
        for (std::uint32_t i = 0; i < node->shears; ++i)
            sheared[shears++] = &shears_[node->first_shear + i];
        if (node->left == 0) break;
        const std::uint32_t s = node->dimension;
        if (u[s] < node->left_share) {
            u[s] /= node->left_share;
            box.high[s] = node->at;
            node = &nodes_[node->left];
        } else {
            u[s] = (u[s] - node->left_share) / (1 - node->left_share);
            box.low[s] = node->at;
            node = &nodes_[node->left + 1];
        }
    }
    for (std::size_t s = 0; s < kGuidedDimensions; ++s)
        u[s] = box.low[s] + u[s] * (box.high[s] - box.low[s]);
    while (shears > 0) sheared[--shears]->undo(u);
    image.density = node->density;
    return image;
}

double EmissionGuide::density(const EmissionPoint& at) const {
    const double own = density_of_tree(at);
    return other_ ? (1 - share_of_other_) * own + share_of_other_ * other_->density(at) : own;
}

double EmissionGuide::density_of_tree(const EmissionPoint& at) const {
    return nodes_.empty() ? 1 : nodes_[box_of(at)].density;
}

std::uint32_t EmissionGuide::box_of(EmissionPoint at) const {
    std::uint32_t number = 0;
    while (true) {
        const Node& node = nodes_[number];
        for (std::uint32_t i = 0; i < node.shears; ++i) shears_[node.first_shear + i].apply(at);
        if (node.left == 0) return number;
        number = node.left + (at[node.dimension] < node.at ? 0 : 1);
    }
}

EmissionGuide EmissionGuide::where_visible(const std::vector<Trial>& trials, double least) const {
    if (is_identity()) return {};
    std::vector<double> tried(nodes_.size());
    std::vector<double> visible(nodes_.size());
    for (const Trial& trial : trials) {
        const std::uint32_t box = box_of(trial.point);
        tried[box] += 1;
        visible[box] += trial.visible ? 1 : 0;
    }
    std::vector<double> masses(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].left != 0) continue;
        const double share = visible[i] / (tried[i] + 1);
        if (share >= least) masses[i] = std::sqrt(share) * nodes_[i].volume;
    }
    return with_masses(std::move(masses));
}

EmissionGuide EmissionGuide::widened(double kept) const {
    if (is_identity()) return {};
    std::vector<double> masses(nodes_.size());
    double roots = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].left != 0) continue;
        masses[i] = std::sqrt(nodes_[i].found * nodes_[i].volume);
        roots += masses[i];
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        if (node.left != 0) continue;
        masses[i] = (1 - kept) * masses[i] / roots + kept * node.density * node.volume;
        if (masses[i] <= node.volume) masses[i] = 0;
    }
    return with_masses(std::move(masses));
}

std::vector<double> EmissionGuide::mean_squares(const std::vector<Worth>& trials) const {
    std::vector<double> count(nodes_.size());
    std::vector<double> square(nodes_.size());
    for (const Worth& trial : trials) {
        const std::uint32_t box = box_of(trial.point);
        count[box] += 1;
        square[box] += trial.square;
    }
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // halves come after the whole
        const std::uint32_t left = nodes_[i].left;
        if (left == 0) continue;
        count[i] = count[left] + count[left + 1];
        square[i] = square[left] + square[left + 1];
    }
    std::vector<double> mean(nodes_.size());
    mean[0] = square[0];
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].left == 0) continue;
        for (std::uint32_t half = nodes_[i].left; half < nodes_[i].left + 2; ++half) {
            const Node& part = nodes_[half];
            // Over that of the whole: zero where nothing was found, however large that is.
            const double density = part.found / nodes_[i].found * nodes_[i].volume / part.volume;
            mean[half] = (count[half] * square[half] / part.volume +
                          kOfParent * mean[i] * std::min(1.0, density / kSparse)) /
                         (count[half] + kOfParent);
        }
    }
    return mean;
}

EmissionGuide EmissionGuide::by_worth(const std::vector<Worth>& trials, double kept,
                                      const Growth& growth) const {
    if (is_identity()) return {};
    std::vector<double> masses = mean_squares(trials);
    double sum = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        masses[i] = nodes_[i].left == 0 ? nodes_[i].volume * std::sqrt(masses[i]) : 0;
        sum += masses[i];
    }
    const double even = growth.uniform_share;
    const double by_worth = sum > 0 ? 1 - kept - even : 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].left == 0)
            masses[i] = (sum > 0 ? by_worth * masses[i] / sum : 0) +
                        (1 - by_worth - even) * nodes_[i].found + even * nodes_[i].volume;
    return with_masses(std::move(masses), growth.spread);
}

EmissionGuide EmissionGuide::with_masses(std::vector<double> masses, double spread) const {
    double all = 0;
    for (const double mass : masses) all += mass;
    if (!(all > 0)) return {};
    EmissionGuide map = *this;
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // halves come after the whole
        Node& node = map.nodes_[i];
        if (node.left == 0) {
            masses[i] /= all;
        } else {
            masses[i] = masses[node.left] + masses[node.left + 1];
            node.left_share = masses[i] > 0 ? masses[node.left] / masses[i] : 0.5;
        }
        node.density = masses[i] / node.volume;
    }
    if (spread > 0) map.spread_masses(spread);
    return map;
}

void EmissionGuide::spread_masses(double share) {
    std::vector<double> masses(nodes_.size());
    masses[0] = 1;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        Node& node = nodes_[i];
        node.density = masses[i] / node.volume;
        if (node.left == 0) continue;
        const double left = nodes_[node.left].volume / node.volume;
        node.left_share = (1 - share) * node.left_share + share * left;
        masses[node.left] = masses[i] * node.left_share;
        masses[node.left + 1] = masses[i] * (1 - node.left_share);
    }
}

}  // namespace sunfleck::engine
