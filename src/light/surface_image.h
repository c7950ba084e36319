// Textured area lights: an image by the surface's (u, v), with sampling by emitted light.
//
// In:  texels in linear sRGB, bilinearly interpolated, row 0 at v = 1, clamped beyond the unit
// square (pbrt-v4).
// Out: radiance at (u, v), and surface points whose density approximates the emission there.
#pragma once

#include "light/light_image.h"
#include "light/surface_uv.h"

#include <memory>

namespace sunfleck::engine {

class SurfaceImage {
public:
    /// @param image  with finite texels. The constructor calls prepare_colours().
    explicit SurfaceImage(Image image);

    TexelLight at(const Vec2& uv) const;
    /// Returns the mean luminance of the texels.
    double mean() const { return mean_; }
    /// Returns the greatest luminance of a texel.
    double peak() const { return peak_; }
    const Vec2i& resolution() const { return image_.resolution(); }
    const Image& image() const { return image_; }

private:
    Image image_;
    double mean_ = 0;
    double peak_ = 0;
};

/// An image placed on the surface of one light.
class PlacedImage {
public:
    /// @param most_cells  of the table for sampling; at least 1.
    PlacedImage(std::shared_ptr<const SurfaceImage> image, const CornerUvs& uvs,
                const EmittingSurface& surface, int most_cells);

    /// A surface point and its light; `density` is that in the unit square.
    struct Drawn {
        SurfaceSample on;
        TexelLight light;
        double density = 0;
    };
    /// Samples points approximately by emission; flux() must not be zero.
    /// @param u  in (0,1)^2.
    Drawn draw(const EmittingSurface& surface, const Vec2d& u) const;

    /// Returns the approximate density of draw() per m^2 at a point of the surface; parameters as
    /// for at().
    /// @param spread  result of surface_spread() there.
    double density(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal,
                   double spread) const;

    /// Inverts draw(): returns the u that leads to a point of the surface.
    Vec2d numbers(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;

    TexelLight at(const Vec2& uv) const { return image_->at(uv); }
    /// Returns the light at a surface point with unit normal `normal` (either side).
    TexelLight at(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) const;
    /// Returns the luminance integrated over the surface, m^2: by 2 x 2 midpoints in each cell.
    double flux() const { return flux_; }

private:
    double mean_over(const EmittingSurface& surface, const Vec2i& cell, int side) const;
    int cells_across(int most_cells) const;

    std::shared_ptr<const SurfaceImage> image_;
    CornerUvs uvs_;
    double flux_ = 0;
    /// Distribution over the unit square that sample_surface() takes: spread times luminance of
    /// each cell, plus a little everywhere, so that every point can be sampled.
    std::unique_ptr<const LightImage> slots_;
};

}  // namespace sunfleck::engine
