// Radiance pictures: three mantissas that share an exponent, plain or packed in runs.
//
// Source: Ward, Real Pixels (Graphics Gems II, 1991); the Radiance file format.
#include "image/byte_source.h"
#include "image/formats.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace sunfleck::engine {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// The size that the last line of the head gives.
Vec2i read_head(ByteSource& source) {
    bool has_format = false;
    for (std::string_view line = source.line(); !line.empty(); line = source.line())
        has_format = has_format || line == "FORMAT=32-bit_rle_rgbe";
    if (!has_format) source.refuse("its values are not RGBE");
    const std::string size(source.line().substr(0, 40));
    Vec2i resolution;
    if (std::sscanf(size.c_str(), "-Y %7d +X %7d", &resolution.y, &resolution.x) != 2)
        source.refuse("its rows do not go from the top left");
    return resolution;
}

/// A row whose four components stand one after the other, each in runs.
void read_new_runs(ByteSource& source, std::vector<Rgbe>& row) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < row.size();) {
            const unsigned packet = source.byte();
            const bool repeats = packet > 128;
            const unsigned count = repeats ? packet - 128 : packet;
            if (count == 0 || count > row.size() - x) source.refuse("a run leaves its row");
            const std::string_view values = source.take(repeats ? 1 : count);
            for (unsigned i = 0; i < count; ++i)
                row[x++].at(c) = static_cast<std::uint8_t>(values[repeats ? 0 : i]);
        }
}

/// A row of whole texels; 1 1 1 n repeats the one before n times, 256 n where two follow.
void read_old_row(ByteSource& source, const Rgbe& first, std::vector<Rgbe>& row) {
    Rgbe texel = first;
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        const bool repeats = texel[0] == 1 && texel[1] == 1 && texel[2] == 1 && x > 0;
        const std::size_t count = repeats ? std::size_t{texel[3]} << shift : 1;
        if (count > row.size() - x || shift > 16) source.refuse("a run leaves its row");
        const Rgbe value = repeats ? row[x - 1] : texel;
        for (std::size_t i = 0; i < count; ++i) row[x++] = value;
        shift = repeats ? shift + 8 : 0;
        if (x == row.size()) return;
        for (std::uint8_t& part : texel) part = source.byte();
    }
}

void read_row(ByteSource& source, std::vector<Rgbe>& row) {
    Rgbe first{};
    for (std::uint8_t& part : first) part = source.byte();
    const bool may_be_new = row.size() >= 8 && row.size() < 32768;
    if (!may_be_new || first[0] != 2 || first[1] != 2 || first[2] > 127)
        return read_old_row(source, first, row);
    if ((std::size_t{first[2]} << 8U | first[3]) != row.size())
        source.refuse("a row of another width");
    read_new_runs(source, row);
}

}  // namespace

Image parse_hdr(std::string_view bytes, const std::string& name) {
    ByteSource source(bytes, name, "HDR");
    const Vec2i resolution = read_head(source);
    // Of old, two texels of four bytes may stand for 65535; no picture is as empty as that.
    source.check_size(resolution.x, resolution.y, source.left() * 256, 12);
    std::vector<Rgbe> row(static_cast<std::size_t>(resolution.x));
    std::vector<float> texels;  // grows with what is read: the claim may be false
    for (int y = 0; y < resolution.y; ++y) {
        read_row(source, row);
        for (const Rgbe& texel : row) {
            const float unit = texel[3] == 0 ? 0 : std::ldexp(1.0F, int{texel[3]} - 136);
            for (std::size_t c = 0; c < 3; ++c)
                texels.push_back(static_cast<float>(texel.at(c)) * unit);
        }
    }
    return {resolution, 3, std::move(texels)};
}

}  // namespace sunfleck::engine
