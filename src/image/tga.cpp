// Truevision TGA: palettes, grey and colours, plain or packed in runs.
//
// Source: Truevision TGA File Format Specification 2.0 (1991).
#include "image/byte_source.h"
#include "image/formats.h"

#include <array>

namespace sunfleck::engine {
namespace {

struct Header {
    unsigned type = 0;  // 1 palette, 2 colours, 3 grey; 8 more when packed
    bool packed = false;
    unsigned palette_first = 0;
    unsigned palette_size = 0;
    unsigned palette_bits = 0;
    unsigned width = 0;
    unsigned height = 0;
    unsigned bits = 0;  // of a texel in the file
    bool from_top = false;
    bool from_right = false;
};

using Colour = std::array<std::uint8_t, 3>;

std::uint8_t from_five_bits(unsigned value) {
    return static_cast<std::uint8_t>((value & 31U) * 255 / 31);
}

std::size_t bytes_of(unsigned bits) {
    return (std::size_t{bits} + 7) / 8;
}

/// A colour as files have it: B G R, perhaps alpha; or 1 + 5 + 5 + 5 bits.
Colour colour_of(std::string_view texel) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(texel[i]); };
    if (texel.size() == 1) return {at(0), at(0), at(0)};
    if (texel.size() > 2) return {at(2), at(1), at(0)};
    const unsigned word = at(0) | static_cast<unsigned>(at(1)) << 8U;
    return {from_five_bits(word >> 10U), from_five_bits(word >> 5U), from_five_bits(word)};
}

Header read_header(ByteSource& source) {
    Header h;
    const unsigned id = source.byte();
    const bool has_palette = source.byte() == 1;
    const unsigned type = source.byte();
    h.packed = type > 8;
    h.type = type & 7U;
    h.palette_first = source.word();
    h.palette_size = source.word();
    h.palette_bits = source.byte();
    source.take(4);  // where it stands on a screen
    h.width = source.word();
    h.height = source.word();
    h.bits = source.byte();
    const unsigned descriptor = source.byte();
    h.from_right = (descriptor & 16U) != 0;
    h.from_top = (descriptor & 32U) != 0;
    source.take(id);
    const bool known_bits =
        h.bits == 8 || h.bits == 15 || h.bits == 16 || h.bits == 24 || h.bits == 32;
    if (h.type < 1 || h.type > 3 || type > 11 || !known_bits)
        source.refuse("type " + std::to_string(type) + " with " + std::to_string(h.bits) +
                      " bits is unknown");
    if ((h.type == 1) != (h.bits == 8 && h.type != 3) || (h.type == 1 && !has_palette))
        source.refuse("its bits do not suit its type");
    if (!has_palette) h.palette_size = 0;
    return h;
}

std::vector<Colour> read_palette(ByteSource& source, const Header& h) {
    const std::size_t size = bytes_of(h.palette_bits);
    if (h.palette_size > 0 && (size < 2 || size > 4)) source.refuse("a palette of odd colours");
    std::vector<Colour> palette;
    for (unsigned i = 0; i < h.palette_size; ++i) palette.push_back(colour_of(source.take(size)));
    return palette;
}

/// Hands out texel after texel, runs unpacked.
class TexelReader {
public:
    TexelReader(ByteSource& source, const Header& header)
        : source_(source), size_(bytes_of(header.bits)), packed_(header.packed) {}

    std::string_view next() {
        if (!packed_) return source_.take(size_);
        if (left_ == 0) {
            const unsigned packet = source_.byte();
            left_ = (packet & 127U) + 1;
            repeats_ = packet > 127;
            if (repeats_) texel_ = source_.take(size_);
        }
        --left_;
        if (!repeats_) texel_ = source_.take(size_);
        return texel_;
    }

private:
    ByteSource& source_;
    std::size_t size_;
    bool packed_;
    unsigned left_ = 0;
    bool repeats_ = false;
    std::string_view texel_;
};

Colour texel_colour(const ByteSource& source, const Header& h, const std::vector<Colour>& palette,
                    std::string_view texel) {
    const Colour colour = colour_of(h.type == 3 ? texel.substr(0, 1) : texel);
    if (h.type != 1) return colour;
    const std::size_t index = colour[0] - std::size_t{h.palette_first};
    if (index >= palette.size()) source.refuse("a colour that its palette has not");
    return palette[index];
}

}  // namespace

Image parse_tga(std::string_view bytes, const std::string& name) {
    ByteSource source(bytes, name, "TGA");
    const Header h = read_header(source);
    const std::vector<Colour> palette = read_palette(source, h);
    const std::size_t per_texel = bytes_of(h.bits);
    source.check_size(h.width, h.height,
                      h.packed ? source.left() * 128 / (per_texel + 1) : source.left() / per_texel,
                      h.type == 3 ? 1 : 3);
    const std::size_t channels = h.type == 3 ? 1 : 3;
    std::vector<std::uint8_t> texels(std::size_t{h.width} * h.height * channels);
    TexelReader reader(source, h);
    for (std::size_t row = 0; row < h.height; ++row) {
        const std::size_t y = h.from_top ? row : h.height - 1 - row;
        for (std::size_t column = 0; column < h.width; ++column) {
            const std::size_t x = h.from_right ? h.width - 1 - column : column;
            const std::string_view texel = reader.next();
            const Colour colour = texel_colour(source, h, palette, texel);
            for (std::size_t c = 0; c < channels; ++c)
                texels[(y * h.width + x) * channels + c] = colour.at(c);
        }
    }
    return {{static_cast<int>(h.width), static_cast<int>(h.height)},
            static_cast<int>(channels),
            std::move(texels)};
}

}  // namespace sunfleck::engine
