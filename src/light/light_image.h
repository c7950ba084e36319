// LightImage: an image as a distribution of light over the unit square, sampled by luminance.
//
// In:  texels in linear sRGB, constant over their squares, x to the right and y down; negative
// components count as zero.
// Out: points with the density luminance / mean luminance, exactly, where each texel may have a
// weight; every texel that is not black can be sampled. Sampling inverts the sums of rows, then of
// a row's texels. It is continuous in u within a row, and between rows that are alike.
#pragma once

#include "image/image.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

/// Light of a texel: luminance times an RGB factor.
struct TexelLight {
    double luminance = 0;
    Vec3 rgb{1};  // RGB of luminance one
};

/// Splits a colour in linear sRGB; negative components count as zero.
TexelLight texel_light(const Vec3& given);

/// Builds the table of colours unless all texels are grey. It is called before parallel work, where
/// the table may not be built.
void prepare_colours(const Image& image);

class LightImage {
public:
    struct Drawn {
        Vec2d place;  // in the unit square
        TexelLight light;
        double density = 0;  // per unit of the unit square
    };
    /// Weight of a texel besides its luminance; positive.
    using Share = std::function<double(int x, int y)>;

    /// @param image  with finite texels. The constructor calls prepare_colours().
    /// @param share  weights; all one if empty.
    explicit LightImage(Image image, const Share& share = {});

    const Vec2i& resolution() const { return image_.resolution(); }
    /// Returns the mean of luminance times weight.
    double mean() const { return mean_; }
    /// Returns the greatest luminance of a texel, without weight.
    double peak() const { return peak_; }
    TexelLight texel(int x, int y) const { return texel_light(image_.rgb(x, y)); }
    /// Returns the texel at a point of the closed unit square.
    TexelLight at(const Vec2d& place) const;
    /// Samples a point; the image must not be black. @param u  in (0,1)^2.
    Drawn draw(const Vec2d& u) const;
    /// Inverts draw(): returns the u that leads to a point of the closed unit square.
    Vec2d numbers(const Vec2d& place) const;
    /// Returns the density of draw() at a point of the closed unit square; the image must not be
    /// black.
    double density(const Vec2d& place) const;

private:
    Vec2i cell(const Vec2d& place) const;
    /// Fills the sums of a row. @return the greatest luminance of its texels.
    double sum_row(int y, const Share& share);

    Image image_;
    std::vector<double> rows_;     // cumulative sums of rows, over the total
    std::vector<double> columns_;  // row by row: cumulative sums of texels, over that of the row
    double mean_ = 0;
    double peak_ = 0;
};

}  // namespace sunfleck::engine
