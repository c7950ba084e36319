// A subpath from the eye and one from a light, joined in every way.
//
// In:  a point of the film, streams of numbers. Out: light for that point, and light for other
// points of the film, which the camera sees of the light's subpath. All strategies are weighted
// (reference/mis_weights.h), so their sums are without bias.
#pragma once

#include "reference/splatter.h"
#include "reference/subpath.h"

namespace sunfleck::engine {

/// What a path pair brings to a point of the film.
struct FilmLight {
    Vec2d film;
    SampledSpectrum light;
};

class PathPair {
public:
    /// @param light_paths  for each camera path through a unit of the film's area, in pixels.
    PathPair(const ReferencePass& pass, const Projection& camera, const Splatter& splatter,
             double light_paths)
        : pass_(pass),
          camera_(camera),
          splatter_(splatter),
          light_paths_(light_paths),
          tracer_(pass, camera, light_paths) {}

    /// Numbers of both subpaths, and of what joins them: apart, so that a change of one leaves the
    /// others where they are.
    struct Numbers {
        PathNumbers eye;
        PathNumbers light;
        PathNumbers joints;
    };

    /// @return radiance along a camera ray through the point, but for what splats() brings and
    /// what lights send straight to the camera.
    SampledSpectrum trace(const Vec2d& film, Numbers& numbers);
    /// Of the last pair: radiance of lights that nothing scatters, along the camera ray.
    SampledSpectrum unscattered() const;
    /// Of the last pair: light times film area, as if the light's subpath were all there is.
    const std::vector<FilmLight>& splats() const { return splats_; }

    std::uint64_t camera_rays() const { return camera_rays_; }
    std::uint64_t light_rays() const { return light_rays_; }

private:
    SampledSpectrum met_lights() const;
    SampledSpectrum sampled_light(const SubpathVertex& vertex, PathNumbers& numbers);
    SampledSpectrum joined(const SubpathVertex& eye, const SubpathVertex& light);
    void splat(const SubpathVertex& vertex, PathNumbers& numbers);
    SampledSpectrum seen(const SubpathVertex& from, const Vec3& way, float distance);

    const ReferencePass& pass_;
    const Projection& camera_;
    const Splatter& splatter_;
    double light_paths_;
    SubpathTracer tracer_;
    Subpath eye_;
    Subpath light_;
    std::vector<FilmLight> splats_;
    std::uint64_t camera_rays_ = 0;
    std::uint64_t light_rays_ = 0;
};

}  // namespace sunfleck::engine
