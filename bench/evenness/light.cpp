// Reading of pictures, and the sums of references.
#include "evenness/light.h"

#include "image/exr.h"
#include "math/colour.h"

#include <cmath>

namespace sunfleck::engine::bench {
namespace {

std::vector<double> luminance(const Picture& picture, const std::string& prefix) {
    std::vector<double> values;
    constexpr std::array<std::string_view, 3> kChannels = {"R", "G", "B"};
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
        const Channel* channel = picture.find(prefix + std::string(kChannels[c]));
        if (channel == nullptr) return {};
        values.resize(channel->values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] += kLuminanceWeights[c] * double{channel->values[i]};
    }
    return values;
}

void add(std::vector<double>& sum, const std::vector<double>& values, double factor) {
    if (sum.empty()) sum.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += factor * values[i];
}

void add_pieces(Reference& reference, const std::vector<std::vector<double>>& pieces) {
    std::vector<std::vector<double>> blocks;
    for (const std::vector<double>& piece : pieces) {
        add(reference.pixels, piece, 1 / static_cast<double>(pieces.size()));
        blocks.push_back(block_means(piece, reference.width));
    }
    const ReferenceBlocks mean = mean_of_blocks(blocks);
    add(reference.blocks.mean, mean.mean, 1);
    add(reference.blocks.variance, mean.variance, 1);
}

}  // namespace

ReferenceBlocks mean_of_blocks(const std::vector<std::vector<double>>& pictures) {
    const auto count = static_cast<double>(pictures.size());
    ReferenceBlocks result;
    for (const std::vector<double>& picture : pictures) add(result.mean, picture, 1 / count);
    result.variance.resize(result.mean.size());
    for (const std::vector<double>& picture : pictures)
        for (std::size_t i = 0; i < picture.size(); ++i)
            result.variance[i] += std::pow(picture[i] - result.mean[i], 2) / (count * (count - 1));
    return result;
}

Light light_of(const std::string& picture) {
    const Picture read = read_exr(picture);
    Light light;
    for (std::size_t part = 0; part < kParts.size(); ++part)
        light[part] = luminance(read, part == 0 ? "" : std::string(kParts[part]) + ".");
    return light;
}

std::vector<Render> reference_renders(const std::string& folder, const TestScene& scene,
                                      const std::string& program, double seconds, int resolution) {
    std::vector<Render> renders;
    for (const ReferencePart& part : scene.reference)
        for (std::uint64_t piece = 0; piece < kReferencePieces; ++piece) {
            Method method{part.name, program, part.flags};
            if (part.caustic_alone) method.flags.insert(method.flags.end(), {"--aovs", "caustic"});
            renders.push_back({folder + "/references/" + part.name + "/" + std::to_string(piece),
                               part.scene_file, method, 1000 + piece, seconds / kReferencePieces,
                               resolution});
        }
    return renders;
}

Reference reference_of(const TestScene& scene, const std::vector<Render>& renders) {
    Reference reference;
    for (std::size_t number = 0; number < scene.reference.size(); ++number) {
        std::vector<std::vector<double>> pieces;
        for (std::size_t i = 0; i < kReferencePieces; ++i) {
            Light light = light_of(renders.at(number * kReferencePieces + i).picture());
            pieces.push_back(std::move(light[scene.reference[number].caustic_alone ? 1 : 0]));
        }
        const auto pixels = static_cast<double>(pieces.front().size());
        reference.width = static_cast<std::size_t>(std::lround(std::sqrt(pixels)));
        add_pieces(reference, pieces);
    }
    return reference;
}

}  // namespace sunfleck::engine::bench
