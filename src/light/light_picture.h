// A picture as a distribution of light over the unit square: bright texels are drawn often.
//
// In:  texels in linear sRGB, constant over their squares, x to the right and y down; negative
// components count as none. Out: places with the density luminance / mean luminance, exactly, each
// weighed by its texel's share where these differ; a texel of any light is drawn. By inverting the
// sums of rows, then of a row's texels: continuous in the numbers within a row, and between rows
// that are alike.
#pragma once

#include "image/image.h"

#include <functional>
#include <vector>

namespace sunfleck::engine {

/// What a texel shines: luminance times tint.
struct TexelLight {
    double luminance = 0;
    Vec3 tint{1};  // of luminance one
};

/// Of a colour in linear sRGB; negative components count as none.
TexelLight texel_light(const Vec3& given);

/// Builds the table of colours if the texels are no greys: now, for it may not be within parallel
/// work.
void prepare_colours(const Image& image);

class LightPicture {
public:
    struct Drawn {
        Vec2d place;  // in the unit square
        TexelLight light;
        double density = 0;  // over the unit square
    };
    /// What a texel weighs, beside its luminance; positive.
    using Share = std::function<double(int x, int y)>;

    /// @param image  its texels finite. Builds the table of colours, if they are no greys.
    /// @param share  all one, if empty.
    explicit LightPicture(Image image, const Share& share = {});

    const Vec2i& resolution() const { return image_.resolution(); }
    /// Mean of luminance times share.
    double mean() const { return mean_; }
    TexelLight texel(int x, int y) const { return texel_light(image_.rgb(x, y)); }
    /// The texel at a place of the closed unit square.
    TexelLight at(const Vec2d& place) const;
    /// Not to be asked of a black picture. @param u  in (0,1)^2.
    Drawn draw(const Vec2d& u) const;
    /// The u that draw() takes to a place of the closed unit square: its inverse.
    Vec2d numbers(const Vec2d& place) const;
    /// Of draw(), at a place of the closed unit square; not to be asked of a black picture.
    double density(const Vec2d& place) const;

private:
    Vec2i cell(const Vec2d& place) const;
    void sum_row(int y, const Share& share);

    Image image_;
    std::vector<double> rows_;     // sums of rows up to each, over that of all
    std::vector<double> columns_;  // row by row: sums of texels up to each, over that of the row
    double mean_ = 0;
};

}  // namespace sunfleck::engine
