// Luminance of pictures and references: all light, and its AOVs.
#pragma once

#include "compare/block_classes.h"
#include "evenness/renders.h"
#include "evenness/views.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine::bench {

/// What is measured. The first is all light.
inline constexpr std::array<std::string_view, 3> kParts = {"all", "caustic", "indirect"};

/// Luminance of each part, row by row; empty for an AOV that the picture lacks.
using Light = std::array<std::vector<double>, kParts.size()>;

/// Returns the mean of pictures in blocks, and the variance of that mean.
ReferenceBlocks mean_of_blocks(const std::vector<std::vector<double>>& pictures);

Light light_of(const std::string& picture);

/// The reference of a scene: all light.
struct Reference {
    std::vector<double> pixels;
    ReferenceBlocks blocks;
    std::size_t width = 0;
};

/// Pieces of each part of a reference: renders with seeds of their own, whose spread says how exact
/// their mean is.
inline constexpr std::uint64_t kReferencePieces = 8;

/// @param seconds  processor time of a part.
std::vector<Render> reference_renders(const std::string& folder, const TestScene& scene,
                                      const std::string& program, double seconds, int resolution);

/// @param renders  those of reference_renders(), done.
Reference reference_of(const TestScene& scene, const std::vector<Render>& renders);

}  // namespace sunfleck::engine::bench
