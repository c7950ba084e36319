// What is compared of a picture: its luminance as a whole and by blocks, and that values are sane.
#pragma once

#include "differential/equivalence.h"
#include "image/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine::differential {

/// Mean luminance of the picture and of its blocks of 8 x 8 pixels.
struct Look {
    double mean = 0;
    std::vector<double> blocks;
};

/// @param prefix  of the channels: "" for the picture, "bias." for its estimated bias.
/// @return zeros where the picture has no such channels.
Look look_at(const Picture& picture, const std::string& prefix = "");

/// a + scale b.
Look sum(Look a, const Look& b, double scale);

/// Luminance of each pixel, with a prefix as above.
std::vector<double> luminances(const Picture& picture, const std::string& prefix = "");

/// Which channel holds a NaN or an infinity, or that luminance is negative.
std::optional<std::string> broken_values(const Picture& picture, bool may_be_negative);

/// Differences that do not matter, and how sure a difference must be.
struct Bands {
    double mean = 0.02;  // of the mean luminance
    double block = 0.1;  // of a block's, or of a quarter of the mean where that is more
    double mean_significance = 0.005;
    double block_significance = 0.005;  // of all blocks together
    Look allowance;  // added to the bands: luminance, by block; none where it has no blocks
};

struct Comparison {
    Verdict verdict = Verdict::equal;  // of mean and blocks together
    Verdict of_mean = Verdict::equal;  // of the mean alone
    std::optional<Excess> excess;      // of a's mean over b's
    std::string text;                  // where it differs most, in errors, and by how much
};

/// @param a, b  looks at independent renders, at least two of each.
Comparison compare(const std::vector<Look>& a, const std::vector<Look>& b, const Bands& bands);

}  // namespace sunfleck::engine::differential
