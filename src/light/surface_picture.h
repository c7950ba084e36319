// The picture of an area light: radiance that varies over an emitting surface by its (u, v).
//
// In:  texels in linear sRGB, between which it is bilinear, row 0 at v = 1; edges go on beyond the
// unit square (pbrt-v4). Out: radiance at a (u, v), and places of the slots of emission with the
// density of what is emitted there.
#pragma once

#include "light/light_picture.h"
#include "light/surface_uv.h"

#include <memory>

namespace sunfleck::engine {

class SurfacePicture {
public:
    /// @param image  its texels finite. Builds the table of colours, if they are no greys.
    explicit SurfacePicture(Image image);

    TexelLight at(const Vec2& uv) const;
    /// Of the luminance of texels.
    double mean() const { return mean_; }
    const Vec2i& resolution() const { return image_.resolution(); }

private:
    Image image_;
    double mean_ = 0;
};

/// A picture as it lies on the surface of one light.
class LaidPicture {
public:
    /// @param most_cells  of the table of what is emitted where; at least 1.
    LaidPicture(std::shared_ptr<const SurfacePicture> picture, const CornerUvs& uvs,
                const EmittingSurface& surface, int most_cells);

    /// A point of the surface, and its light; `density` is that of the slots that led there.
    struct Drawn {
        SurfaceSample on;
        TexelLight light;
        double density = 0;
    };
    /// About as often where more is emitted. Not to be asked where flux() is zero.
    /// @param u  in (0,1)^2.
    Drawn draw(const EmittingSurface& surface, const Vec2d& u) const;

    /// About the density of draw(), per m^2, at a point of the surface: as at() takes it.
    /// @param spread  of surface_spread() there.
    double density(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal,
                   double spread) const;

    /// The u that draw() takes to a point of the surface: its inverse.
    Vec2d numbers(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;

    TexelLight at(const Vec2& uv) const { return picture_->at(uv); }
    /// At a point of the surface, whose unit normal (either side) is `normal`.
    TexelLight at(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;
    /// Luminance integrated over the surface, m^2: by midpoints, two each way in each cell.
    double flux() const { return flux_; }

private:
    double mean_over(const EmittingSurface& surface, const Vec2i& cell, int side) const;
    int cells_across(int most_cells) const;

    std::shared_ptr<const SurfacePicture> picture_;
    CornerUvs uvs_;
    double flux_ = 0;
    /// The unit square of the slots that sample_surface() takes: spread times luminance of each
    /// cell, and everywhere a little more, for no place may be forgotten.
    std::unique_ptr<const LightPicture> slots_;
};

}  // namespace sunfleck::engine
