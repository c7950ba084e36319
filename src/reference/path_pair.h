// PathPair: a camera subpath and a light subpath with all their connections.
//
// In:  a film point, random numbers. Out: light at that point, and light at other film points by
// connections of the light subpath to the camera. All strategies have MIS weights
// (reference/mis_weights.h), so the sums are unbiased.
#pragma once

#include "reference/splatter.h"
#include "reference/subpath.h"

namespace sunfleck::engine {

/// Light at a film point.
struct FilmLight {
    Vec2d film;
    SampledSpectrum light;
};

class PathPair {
public:
    /// @param light_paths  per camera path through a unit of film area, in pixels.
    PathPair(const ReferencePass& pass, const Projection& camera, const Splatter& splatter,
             double light_paths)
        : pass_(pass),
          camera_(camera),
          splatter_(splatter),
          light_paths_(light_paths),
          tracer_(pass, camera, light_paths) {}

    /// Numbers of both subpaths and of their connections; they are separate, so that a change of
    /// one leaves the others unchanged.
    struct Numbers {
        PathNumbers camera;
        PathNumbers light;
        PathNumbers joints;
    };

    /// @return radiance along a camera ray through the point, without splats() and directly seen
    /// lights.
    SampledSpectrum trace(const Vec2d& film, Numbers& numbers);
    /// Returns the radiance of lights seen directly along the camera ray of the last pair.
    SampledSpectrum unscattered() const;
    /// Returns light times film area of the last pair, as if there were no other light subpaths.
    const std::vector<FilmLight>& splats() const { return splats_; }

    std::uint64_t camera_rays() const { return camera_rays_; }
    std::uint64_t light_rays() const { return light_rays_; }

private:
    SampledSpectrum met_lights() const;
    SampledSpectrum sampled_light(const SubpathVertex& vertex, PathNumbers& numbers);
    SampledSpectrum joined(const SubpathVertex& camera, const SubpathVertex& light);
    void splat(const SubpathVertex& vertex, PathNumbers& numbers);
    SampledSpectrum seen(const SubpathVertex& from, const Vec3& way, float distance);

    const ReferencePass& pass_;
    const Projection& camera_;
    const Splatter& splatter_;
    double light_paths_;
    SubpathTracer tracer_;
    Subpath camera_subpath_;
    Subpath light_;
    std::vector<FilmLight> splats_;
    std::uint64_t camera_rays_ = 0;
    std::uint64_t light_rays_ = 0;
};

}  // namespace sunfleck::engine
