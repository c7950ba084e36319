// Portable float maps: floats of either byte order, rows from the bottom.
//
// Source: Debevec, PFM Portable FloatMap Image Format.
#include "core/printable.h"
#include "image/byte_source.h"
#include "image/formats.h"

#include <bit>
#include <cmath>
#include <cstdio>

namespace sunfleck::engine {
namespace {

struct Head {
    int channels = 1;
    Vec2i resolution;
    float scale = 1;
};

/// The next word, which a single white space ends, or a line end of two bytes.
std::string word_of(ByteSource& source) {
    std::string word;
    for (char c = source.take(1)[0];; c = source.take(1)[0]) {
        const bool white = c == ' ' || c == '\n' || c == '\r' || c == '\t';
        if (white && !word.empty()) {
            if (c == '\r') source.skip('\n');
            return word;
        }
        if (!white) word += c;
        if (word.size() > 40) source.refuse("its head is none");
    }
}

Head read_head(ByteSource& source) {
    Head head;
    const std::string kind = word_of(source);
    if (kind != "PF" && kind != "Pf") source.refuse("it is of the kind " + printable(kind, 8));
    head.channels = kind == "PF" ? 3 : 1;
    const std::string width = word_of(source);
    const std::string height = word_of(source);
    const std::string scale = word_of(source);
    const std::string all = width + " " + height + " " + scale;
    const int read = std::sscanf(all.c_str(), "%7d %7d %30f", &head.resolution.x,
                                 &head.resolution.y, &head.scale);
    if (read != 3 || !std::isfinite(head.scale) || head.scale == 0)
        source.refuse("its head names no size and scale");
    return head;
}

float float_of(std::string_view bytes, bool small_end_first) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto byte = static_cast<std::uint8_t>(bytes[small_end_first ? 3 - i : i]);
        bits = bits << 8U | byte;
    }
    return std::bit_cast<float>(bits);
}

}  // namespace

Image parse_pfm(std::string_view bytes, const std::string& name) {
    ByteSource source(bytes, name, "PFM");
    const Head head = read_head(source);
    const auto channels = static_cast<std::size_t>(head.channels);
    source.check_size(head.resolution.x, head.resolution.y, source.left() / (4 * channels),
                      4 * channels);
    const auto row = static_cast<std::size_t>(head.resolution.x) * channels;
    const auto rows = static_cast<std::size_t>(head.resolution.y);
    std::vector<float> texels(row * rows);
    for (std::size_t y = rows; y-- > 0;)
        for (std::size_t i = 0; i < row; ++i)
            texels[y * row + i] = float_of(source.take(4), head.scale < 0) * std::abs(head.scale);
    return {head.resolution, head.channels, std::move(texels)};
}

}  // namespace sunfleck::engine
