// An image for textures and lights, as a plain value: texels in the size that their file had.
//
// In:  integers of 8 bits with an encoding, halves or floats. Out: linear light, by texel.
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

/// How integers stand for light.
struct Encoding {
    enum class Kind { linear, srgb, gamma };
    Kind kind = Kind::srgb;
    float exponent = 1;  // of Kind::gamma: light = value^exponent

    /// Linear light of an encoded value in [0,1].
    float decode(float value) const;

    friend bool operator==(const Encoding&, const Encoding&) = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): seen in code that the compiler writes
    friend auto operator<=>(const Encoding&, const Encoding&) = default;
};

/// Texels of a file that had values which are no finite numbers.
struct BrokenTexels {
    std::size_t count = 0;
    Vec2i first{0, 0};  // the first of them, rows from the top
};

/// Channels: 1 is grey, 3 are R G B, 4 are R G B and alpha.
class Image {
public:
    using Texels = std::variant<std::vector<std::uint8_t>, std::vector<half>, std::vector<float>>;

    Image() = default;
    /// @param texels  width * height * channels values, texel after texel, rows from the top.
    /// @param encoding  of 8 bits; halves and floats are linear.
    Image(const Vec2i& resolution, int channels, Texels texels, const Encoding& encoding = {});

    const Vec2i& resolution() const { return resolution_; }
    int channels() const { return channels_; }
    const Texels& texels() const { return texels_; }
    /// Does the file say that its colours have other primaries than those of sRGB?
    bool has_other_primaries() const { return has_other_primaries_; }
    void set_other_primaries() { has_other_primaries_ = true; }
    /// Which channels of the file were taken for its colours, where that needs to be said; or
    /// empty.
    const std::string& remark() const { return remark_; }
    void set_remark(std::string remark) { remark_ = std::move(remark); }

    /// The texels that mend_broken() found.
    const BrokenTexels& broken() const { return broken_; }
    /// Values that are infinite become 65504, the greatest half; NaN and what is infinitely
    /// negative become 0. They are counted in broken().
    void mend_broken();

    /// All channels of a texel, as linear light; zero where there are fewer than four.
    /// @param x  in [0, width) from the left. @param y  in [0, height) from the top.
    std::array<float, 4> at(int x, int y) const;

    /// The colour of a texel, linear; a grey thrice.
    Vec3 rgb(int x, int y) const {
        const std::array<float, 4> v = at(x, y);
        return channels_ < 3 ? Vec3(v[0]) : Vec3(v[0], v[1], v[2]);
    }

    /// The first `count` channels alone. @param count  at least 1.
    Image with_channels(int count) const;
    /// Is there an alpha, and is it other than one anywhere?
    bool has_holes() const;

private:
    Vec2i resolution_{0, 0};
    int channels_ = 1;
    Texels texels_;
    std::array<float, 256> light_{};  // of 8 bits
    bool has_other_primaries_ = false;
    std::string remark_;
    BrokenTexels broken_;
};

}  // namespace sunfleck::engine
