// Subpaths of bidirectional path tracing: surfaces met one after the other, from the eye or from a
// light, with all that is needed to join them.
#pragma once

#include "camera/projection.h"
#include "reference/mis_weights.h"
#include "reference/path_integrator.h"
#include "reference/path_numbers.h"

#include <vector>

namespace sunfleck::engine {

/// A surface that scatters. Local: the frame of its shading normal.
struct SubpathVertex {
    Hit hit;
    Frame frame;
    Bsdf bsdf;
    Vec3 wo;                   // local, unit, to the vertex before
    float adjoint = 1;         // from a light: cosines of shading over geometric normal, arriving
    SampledSpectrum arriving;  // importance, or flux
    HeroWavelength hero;       // of `arriving`
    MediumNumber medium = 0;   // in which the path came
    PathWeights weighing;
    Departure leaving;  // the way the subpath went on, where it did

    bool is_wide() const { return scattering(bsdf) != Scattering::specular; }
};

/// A light that the eye's subpath met.
struct MetLight {
    std::size_t vertices = 0;  // of the subpath before it
    std::uint32_t light = 0;
    LightRay ray;          // to the last of these
    SampledSpectrum seen;  // radiance as it arrives, times importance
};

struct Subpath {
    std::vector<SubpathVertex> vertices;
    std::vector<MetLight> lights;

    void clear() {
        vertices.clear();
        lights.clear();
    }
};

/// What a vertex does with light between its subpath and a direction.
struct Scattered {
    SampledSpectrum
        weight;  // bsdf times the cosine at the end where flux arrives, adjoint cosines included
    Departure leaving;
    float cosine = 0;  // with the geometric normal
};

/// Of a vertex that is wide. @param way  unit, world. @param transport  of its own subpath.
Scattered scattered(const SubpathVertex& vertex, const Vec3& way, Transport transport);

/// What the light of that number is to a surface at its ray's other end.
EndDensities end_densities(const Scene& scene, std::uint32_t number, const LightRay& ray,
                           const Hit& at);

/// Traces subpaths; one for each thread, used again and again.
class SubpathTracer {
public:
    /// @param light_paths  as first_of_eye() takes them. All are referred to.
    SubpathTracer(const ReferencePass& pass, const Projection& camera, double light_paths)
        : pass_(pass), camera_(camera), light_paths_(light_paths) {}

    /// From the camera. @param film  in pixels. @param wavelength  of dispersion.
    void trace_eye(const Vec2d& film, std::size_t wavelength, PathNumbers& numbers, Subpath& path);
    /// From a light; empty where none shines. Lights are chosen by power.
    void trace_light(std::size_t wavelength, PathNumbers& numbers, Subpath& path);

    std::uint64_t rays() const { return rays_; }

private:
    void follow(PathNumbers& numbers, Subpath& path);
    bool next_surface(Subpath& path);
    void note_lights(bool met, Subpath& path);
    SubpathVertex arrive(const Subpath& path);
    bool scatter(PathNumbers& numbers, SubpathVertex& vertex, std::size_t depth);
    float survival(const SampledSpectrum& before) const;

    const ReferencePass& pass_;
    const Projection& camera_;
    double light_paths_;
    std::uint64_t rays_ = 0;

    // The path at hand.
    Transport transport_ = Transport::radiance;
    SampledSpectrum throughput_;
    HeroWavelength hero_;
    MediumNumber medium_ = 0;
    Vec3 direction_{0};
    Meeting meeting_;
    Hit hit_;
    float unlit_ = 0;
    float scale_ = 1;  // squared ratio of indices, for Russian roulette
    Vec2d lens_{0};
    std::uint32_t light_ = 0;
    LightRay start_;  // or the camera's ray
};

}  // namespace sunfleck::engine
