// Luminance, blocks, and the comparison of both.
#include "differential/look.h"

#include "math/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine::differential {
namespace {

constexpr int kBlock = 8;

/// Blocks tell little of their variance by few renders: they share what they have in common, its
/// mean over blocks, as if it had been seen with so many degrees of freedom more.
constexpr double kSharedDegrees = 4;

std::vector<double> values_of(const std::vector<Look>& looks, std::size_t block) {
    std::vector<double> values;
    for (const Look& look : looks) values.push_back(look.blocks[block]);
    return values;
}

/// Mean over blocks of the variance of one render's block.
double shared_variance(const std::vector<Look>& looks) {
    double total = 0;
    const std::size_t blocks = looks.front().blocks.size();
    for (std::size_t b = 0; b < blocks; ++b) {
        const double error = mean_of(values_of(looks, b)).error;
        total += error * error * static_cast<double>(looks.size());
    }
    return total / static_cast<double>(blocks);
}

std::vector<double> means_of(const std::vector<Look>& looks) {
    std::vector<double> values;
    for (const Look& look : looks) values.push_back(look.mean);
    return values;
}

/// Joins the verdicts of single comparisons, and keeps the text of the worst.
class Joined {
public:
    void add(const MeanOf& a, const MeanOf& b, double band, double significance,
             const std::string& where) {
        const Verdict verdict = decide(a, b, band, significance);
        if (verdict == Verdict::different) found_.verdict = Verdict::different;
        if (verdict == Verdict::undecided && found_.verdict == Verdict::equal)
            found_.verdict = Verdict::undecided;
        const double error = std::hypot(a.error, b.error);
        const double beyond = (std::abs(a.mean - b.mean) - band) / std::max(error, 1e-30);
        if (beyond < worst_) return;
        worst_ = beyond;
        found_.text = fmt::format("{}: {:.4g} against {:.4g}, ratio {:.3f}, error {:.2g}", where,
                                  a.mean, b.mean, b.mean > 0 ? a.mean / b.mean : 0, error);
    }
    /// What was added so far is the mean.
    void keep_as_mean(const std::optional<Excess>& excess) {
        found_.of_mean = found_.verdict;
        found_.excess = excess;
    }
    const Comparison& found() const { return found_; }

private:
    Comparison found_;
    double worst_ = -1e300;
};

/// Returns the largest of a pixel's components, or zero if all are negative.
double largest_component(const Picture& picture, std::size_t pixel) {
    float largest = 0;
    for (const char* name : {"R", "G", "B"})
        if (const Channel* channel = picture.find(name))
            largest = std::max(largest, channel->values[pixel]);
    return largest;
}

}  // namespace

std::vector<double> luminances(const Picture& picture, const std::string& prefix) {
    std::vector<double> values(picture.pixels(), 0);
    for (std::size_t c = 0; c < 3; ++c)
        if (const Channel* channel = picture.find(prefix + "RGB"[c]))
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += kLuminanceWeights[c] * static_cast<double>(channel->values[i]);
    return values;
}

Look look_at(const Picture& picture, const std::string& prefix) {
    const std::vector<double> values = luminances(picture, prefix);
    Look look;
    for (const double value : values) look.mean += value / static_cast<double>(values.size());
    for (int top = 0; top < picture.height; top += kBlock)
        for (int left = 0; left < picture.width; left += kBlock) {
            double sum = 0;
            int count = 0;
            for (int y = top; y < std::min(top + kBlock, picture.height); ++y)
                for (int x = left; x < std::min(left + kBlock, picture.width); ++x, ++count)
                    sum += values[static_cast<std::size_t>(y * picture.width + x)];
            look.blocks.push_back(sum / count);
        }
    return look;
}

Look sum(Look a, const Look& b, double scale) {
    a.mean += scale * b.mean;
    for (std::size_t i = 0; i < a.blocks.size(); ++i) a.blocks[i] += scale * b.blocks[i];
    return a;
}

std::optional<std::string> broken_values(const Picture& picture, bool may_be_negative) {
    for (const Channel& channel : picture.channels)
        for (const float value : channel.values)
            if (!std::isfinite(value)) return fmt::format("{} holds {}", channel.name, value);
    if (may_be_negative) return {};
    const std::vector<double> values = luminances(picture);
    // Adaptation to another white leaves almost pure violet less than none: .2% of its blue.
    constexpr double kOfAdaptation = 0.02;
    const double most = *std::max_element(values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] < -1e-6 * most && values[i] < -kOfAdaptation * largest_component(picture, i))
            return fmt::format("a pixel has luminance {:.3g}", values[i]);
    return {};
}

Comparison compare(const std::vector<Look>& a, const std::vector<Look>& b, const Bands& bands) {
    const std::size_t blocks = a.front().blocks.size();
    const double of_block = bands.block_significance / static_cast<double>(blocks);
    const bool is_wider = !bands.allowance.blocks.empty();
    Joined joined;
    const MeanOf mean_a = mean_of(means_of(a));
    const MeanOf mean_b = mean_of(means_of(b));
    joined.add(mean_a, mean_b,
               bands.mean * mean_b.mean + (is_wider ? std::abs(bands.allowance.mean) : 0),
               bands.mean_significance, "mean");
    joined.keep_as_mean(excess_of(mean_a, mean_b));
    const Prior prior_a{shared_variance(a), kSharedDegrees};
    const Prior prior_b{shared_variance(b), kSharedDegrees};
    for (std::size_t i = 0; i < blocks; ++i) {
        const MeanOf block = mean_of(values_of(b, i), prior_b);
        const double band = bands.block * std::max(block.mean, mean_b.mean / 4) +
                            (is_wider ? std::abs(bands.allowance.blocks[i]) : 0);
        joined.add(mean_of(values_of(a, i), prior_a), block, band, of_block,
                   "block " + std::to_string(i));
    }
    return joined.found();
}

}  // namespace sunfleck::engine::differential
