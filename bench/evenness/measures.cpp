// Errors of pictures against references.
#include "evenness/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sunfleck::engine::bench {
namespace {

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Returns the mean of the pictures in blocks, with a variance that leaves the squared difference
/// of each of them from it unbiased: that difference lacks what the mean shares with the picture.
ReferenceBlocks own_mean(const std::vector<std::vector<double>>& pictures) {
    ReferenceBlocks mean = mean_of_blocks(pictures);
    for (double& variance : mean.variance) variance = -variance;
    return mean;
}

void measure_part(SceneErrors& errors, std::size_t part, const BlockClasses& classes,
                  const ReferenceBlocks& reference,
                  const std::vector<std::vector<double>>& pictures) {
    for (std::size_t seed = 0; seed < pictures.size(); ++seed) {
        PictureErrors& picture = errors.pictures[seed];
        picture.classes[part] = class_errors(classes, reference, pictures[seed]);
        for (ClassError& error : picture.classes[part]) {
            error.plain *= picture.time_scale;
            error.trimmed *= picture.time_scale;
        }
    }
}

PictureErrors errors_of_picture(const Reference& reference, const Render& render,
                                const std::vector<double>& pixels) {
    PictureErrors errors;
    errors.cpu_seconds = render.taken();
    errors.time_scale = errors.cpu_seconds / render.cpu_seconds;
    errors.relative = errors.time_scale *
                      relative_square_error(reference.blocks, block_means(pixels, reference.width));
    errors.spots = spots_of(reference.pixels, pixels, reference.width);
    errors.brightness = sum_of(pixels) / sum_of(reference.pixels);
    return errors;
}

}  // namespace

SceneErrors errors_of(const Reference& reference, const std::vector<Render>& renders) {
    SceneErrors errors;
    std::array<std::vector<std::vector<double>>, kParts.size()> blocks;
    for (const Render& render : renders) {
        const Light light = light_of(render.picture());
        errors.pictures.push_back(errors_of_picture(reference, render, light[0]));
        for (std::size_t part = 0; part < kParts.size(); ++part)
            blocks[part].push_back(block_means(light[part], reference.width));
    }
    const BlockClasses classes(reference.blocks.mean);
    for (std::size_t part = 0; part < kParts.size(); ++part)
        if (!blocks[part].front().empty())
            measure_part(errors, part, classes,
                         part == 0 ? reference.blocks : own_mean(blocks[part]), blocks[part]);
    return errors;
}

double SceneErrors::rms(std::size_t part, std::size_t number, double ClassError::*kind) const {
    double square = 0;
    for (const PictureErrors& picture : pictures) square += picture.classes[part][number].*kind;
    return std::sqrt(std::max(0.0, square / static_cast<double>(pictures.size())));
}

double SceneErrors::mean(double PictureErrors::*number) const {
    double sum = 0;
    for (const PictureErrors& picture : pictures) sum += picture.*number;
    return sum / static_cast<double>(pictures.size());
}

}  // namespace sunfleck::engine::bench
