// Splatter: adds light at film points to all pixels whose filter covers them.
#pragma once

#include "camera/filter.h"
#include "reference/path_integrator.h"

namespace sunfleck::engine {

class Splatter {
public:
    /// Both arguments outlive this.
    Splatter(const ReferencePass& pass, PassImage& image);

    /// Returns whether any pixel's filter covers a point. @param film  in pixels, as for
    /// camera_ray().
    bool reaches(const Vec2d& film) const {
        return film.x > reach_[0] && film.x < reach_[1] && film.y > reach_[2] && film.y < reach_[3];
    }
    /// Thread-safe. @param light  radiance times film area, in pixels.
    void add(const Vec2d& film, const SampledSpectrum& light) const;

    /// Returns the film area that filters cover: x0 x1 y0 y1, in pixels.
    const std::array<double, 4>& reach() const { return reach_; }

private:
    void add_at(const Vec2d& film, const Vec3& rgb) const;

    FilterSettings filter_;
    double scale_;
    PixelWindow window_;
    std::array<double, 4> reach_;
    const Camera& camera_;
    const Wavelengths& wavelengths_;
    PassImage& image_;
};

}  // namespace sunfleck::engine
