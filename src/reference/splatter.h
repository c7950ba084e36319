// Adds light that arrives at points of the film to all pixels whose filter reaches there.
#pragma once

#include "camera/filter.h"
#include "reference/path_integrator.h"

namespace sunfleck::engine {

class Splatter {
public:
    /// Both outlive this.
    Splatter(const ReferencePass& pass, PassImage& image);

    /// Does any pixel's filter reach there? @param film  in pixels, as camera_ray() takes it.
    bool reaches(const Vec2d& film) const {
        return film.x > reach_[0] && film.x < reach_[1] && film.y > reach_[2] && film.y < reach_[3];
    }
    /// Any number of threads. @param light  radiance times film area, in pixels.
    void add(const Vec2d& film, const SampledSpectrum& light) const;

    /// Where points of the film that filters reach are: x0 x1 y0 y1, in pixels.
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
