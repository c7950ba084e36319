// Means of blocks, and their errors.
#include "compare/block_classes.h"

#include "compare/relative_square.h"

#include <algorithm>
#include <numeric>

namespace sunfleck::engine {
namespace {

constexpr double kTrimmed = 0.05;  // of the blocks of a class

double mean_of(const std::vector<double>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// Returns the squared error of a block, less the variance of the reference.
double square_of(const ReferenceBlocks& reference, const std::vector<double>& blocks,
                 std::size_t block) {
    const double difference = blocks.at(block) - reference.mean.at(block);
    return difference * difference - reference.variance.at(block);
}

}  // namespace

std::vector<double> block_means(std::span<const double> pixels, std::size_t width) {
    const std::size_t across = width / kClassBlock;
    const std::size_t down = pixels.size() / width / kClassBlock;
    std::vector<double> means(across * down, 0);
    for (std::size_t y = 0; y < down * kClassBlock; ++y)
        for (std::size_t x = 0; x < across * kClassBlock; ++x)
            means[y / kClassBlock * across + x / kClassBlock] += pixels[y * width + x];
    for (double& mean : means) mean /= static_cast<double>(kClassBlock * kClassBlock);
    return means;
}

BlockClasses::BlockClasses(const std::vector<double>& brightness) {
    const double picture = mean_of(brightness);
    for (std::size_t block = 0; block < brightness.size(); ++block) {
        const double* const above = std::upper_bound(kClassEdges.begin() + 1, kClassEdges.end() - 1,
                                                     brightness[block] / picture);
        const auto number = static_cast<std::size_t>(above - kClassEdges.begin()) - 1;
        blocks_.at(number).push_back(block);
        means_.at(number) += brightness[block];
    }
    for (std::size_t number = 0; number < kClassCount; ++number)
        if (!blocks_[number].empty()) means_[number] /= static_cast<double>(blocks_[number].size());
}

std::array<ClassError, kClassCount> class_errors(const BlockClasses& classes,
                                                 const ReferenceBlocks& reference,
                                                 const std::vector<double>& blocks) {
    std::array<ClassError, kClassCount> errors;
    for (std::size_t number = 0; number < kClassCount; ++number) {
        std::vector<double> squares;
        for (const std::size_t block : classes.blocks(number))
            squares.push_back(square_of(reference, blocks, block));
        const double scale = classes.mean(number) * classes.mean(number);
        if (squares.empty() || !(scale > 0)) continue;
        errors[number].plain = mean_of(squares) / scale;
        std::sort(squares.begin(), squares.end());
        const auto worst = static_cast<std::size_t>(kTrimmed * static_cast<double>(squares.size()));
        squares.resize(squares.size() - worst);
        errors[number].trimmed = mean_of(squares) / scale;
    }
    return errors;
}

double relative_square_error(const ReferenceBlocks& reference, const std::vector<double>& blocks) {
    const double picture = mean_of(reference.mean);
    double sum = 0;
    for (std::size_t block = 0; block < blocks.size(); ++block)
        sum +=
            relative_square(square_of(reference, blocks, block), reference.mean.at(block), picture);
    return sum / static_cast<double>(blocks.size());
}

}  // namespace sunfleck::engine
