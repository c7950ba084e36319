// Image: texels for textures and lights, stored in the precision of their file.
//
// In:  8-bit integers with an encoding, halves or floats. Out: linear light per texel.
#pragma once

#include "math/vector.h"

#include <half.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::engine {

/// Encoding of 8-bit values.
struct Encoding {
    enum class Kind { linear, srgb, gamma };
    Kind kind = Kind::srgb;
    float exponent = 1;  // of Kind::gamma: light = value^exponent

    /// Returns the linear light of an encoded value in [0,1].
    float decode(float value) const;

    friend bool operator==(const Encoding&, const Encoding&) = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): seen in code that the compiler writes
    friend auto operator<=>(const Encoding&, const Encoding&) = default;
};

/// Texels of a file whose values were NaN or infinite.
struct BrokenTexels {
    std::size_t count = 0;
    Vec2i first{0, 0};  // rows from the top
};

/// An image of 1 (grey), 3 (RGB) or 4 (RGBA) channels.
class Image {
public:
    using Texels = std::variant<std::vector<std::uint8_t>, std::vector<half>, std::vector<float>>;

    Image() = default;
    /// @param texels  width * height * channels values, pixel by pixel, rows from the top.
    /// @param encoding  of 8-bit values; halves and floats are linear.
    Image(const Vec2i& resolution, int channels, Texels texels, const Encoding& encoding = {});

    const Vec2i& resolution() const { return resolution_; }
    int channels() const { return channels_; }
    const Texels& texels() const { return texels_; }
    /// Returns whether the file declares primaries other than those of sRGB.
    bool has_other_primaries() const { return has_other_primaries_; }
    void set_other_primaries() { has_other_primaries_ = true; }
    /// Returns a note on which channels were read as colours, or empty if none is needed.
    const std::string& remark() const { return remark_; }
    void set_remark(std::string remark) { remark_ = std::move(remark); }

    /// Returns the texels that mend_broken() replaced.
    const BrokenTexels& broken() const { return broken_; }
    /// Replaces infinite values by 65504, the largest half, and NaN and negative infinity by 0.
    /// broken() counts them.
    void mend_broken();

    /// Returns all channels of a texel as linear light; missing channels are zero.
    /// @param x  in [0, width) from the left.
    /// @param y  in [0, height) from the top.
    std::array<float, 4> at(int x, int y) const;

    /// Returns the linear colour of a texel; grey is repeated.
    Vec3 rgb(int x, int y) const {
        const std::array<float, 4> v = at(x, y);
        return channels_ < 3 ? Vec3(v[0]) : Vec3(v[0], v[1], v[2]);
    }

    /// Returns an image of the first `count` channels. @param count  at least 1.
    Image with_channels(int count) const;
    /// Returns whether the image has an alpha channel that is not one everywhere.
    bool has_holes() const;

private:
    Vec2i resolution_{0, 0};
    int channels_ = 1;
    Texels texels_;
    std::array<float, 256> light_{};  // decoded value of each 8-bit value
    bool has_other_primaries_ = false;
    std::string remark_;
    BrokenTexels broken_;
};

}  // namespace sunfleck::engine
