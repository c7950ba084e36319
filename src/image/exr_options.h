// How an OpenEXR file is stored: sizes of numbers, compression, parts.
#pragma once

#include "core/named_rows.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sunfleck::engine {

enum class ExrCompression { none, zip, piz, dwaa, dwab };

inline constexpr std::array<ChoiceRow<ExrCompression>, 5> kExrCompressions = {{
    {ExrCompression::none, "none", "for programs that read nothing else"},
    {ExrCompression::zip, "zip", "exact"},
    {ExrCompression::piz, "piz", "exact, by wavelets"},
    {ExrCompression::dwaa, "dwaa", "small and inexact, 32 rows at a time"},
    {ExrCompression::dwab, "dwab", "the same, 256 rows at a time"},
}};

struct ExrOptions {
    bool half = false;  // 16-bit floats: half the size, 3 digits, at most 65504
    std::vector<std::string> half_layers{};  // layers (exr_layer()) that have them if not all do
    ExrCompression compression = ExrCompression::zip;
    bool parts = false;  // each layer in a part of its own, which has the layer's name
};

/// Returns the layer of a channel: its name before the last dot, or "picture".
inline std::string exr_layer(const std::string& channel) {
    const std::size_t dot = channel.rfind('.');
    return dot == std::string::npos ? "picture" : channel.substr(0, dot);
}

}  // namespace sunfleck::engine
