// Errors of a picture by blocks of pixels, in classes of brightness.
//
// In:  block means of a picture, and those of a reference with their variances. Out: squared errors
// of each class. The mean error of a picture hides what a user sees first: noise in the dark.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace sunfleck::engine {

/// Side of a block in pixels.
inline constexpr std::size_t kClassBlock = 8;

/// Class c holds the blocks whose brightness, over that of the picture, is at least
/// kClassEdges[c] and below kClassEdges[c + 1].
inline constexpr std::array<double, 5> kClassEdges = {0, 0.02, 0.1, 0.5,
                                                      std::numeric_limits<double>::infinity()};
inline constexpr std::size_t kClassCount = kClassEdges.size() - 1;

/// Returns the means of blocks, row by row. Pixels beyond the last whole block are left out.
/// @param pixels  row by row. @param width  in pixels.
std::vector<double> block_means(std::span<const double> pixels, std::size_t width);

/// The blocks of a reference: estimates, and the variances of these.
struct ReferenceBlocks {
    std::vector<double> mean;
    std::vector<double> variance;
};

/// Which block belongs to which class.
class BlockClasses {
public:
    /// @param brightness  of the reference's blocks, all light together.
    explicit BlockClasses(const std::vector<double>& brightness);

    const std::vector<std::size_t>& blocks(std::size_t number) const { return blocks_.at(number); }
    /// Returns the mean brightness of a class that has blocks.
    double mean(std::size_t number) const { return means_.at(number); }

private:
    std::array<std::vector<std::size_t>, kClassCount> blocks_;
    std::array<double, kClassCount> means_{};
};

/// Mean squared error of a class over the square of its mean brightness, less the reference's own.
/// A mean over many pictures is unbiased.
struct ClassError {
    double plain = 0;
    double trimmed = 0;  // without the worst 5% of the blocks
};

/// Returns the error of each class; zeros for a class without blocks.
/// @param reference  of all light or of one AOV: both are measured by the classes of all light.
std::array<ClassError, kClassCount> class_errors(const BlockClasses& classes,
                                                 const ReferenceBlocks& reference,
                                                 const std::vector<double>& blocks);

/// Returns the mean over blocks of the squared error over reference^2 + 0.01 mean^2, less the
/// reference's own.
double relative_square_error(const ReferenceBlocks& reference, const std::vector<double>& blocks);

}  // namespace sunfleck::engine
