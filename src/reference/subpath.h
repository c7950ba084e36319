// Subpaths of bidirectional path tracing: the vertices from the camera or from a light, with the
// data for connections.
#pragma once

#include "camera/projection.h"
#include "reference/mis_weights.h"
#include "reference/path_integrator.h"
#include "reference/path_numbers.h"

#include <vector>

namespace sunfleck::engine {

/// A scattering vertex. "Local" means the frame of its shading normal.
struct SubpathVertex {
    Hit hit;
    Frame frame;
    Bsdf bsdf;
    Vec3 wo;                   // local, unit, to the previous vertex
    float adjoint = 1;         // on a light subpath: shading-normal correction, arriving
    SampledSpectrum arriving;  // importance or flux
    HeroWavelength hero;       // of `arriving`
    MediumNumber medium = 0;   // of the incoming segment
    PathWeights weights;
    DirectionDensities leaving;  // of the next direction, if the subpath continued

    bool is_wide() const { return scattering(bsdf) != Scattering::specular; }
};

/// A light hit by the camera subpath.
struct LightHit {
    std::size_t vertices = 0;  // of the subpath before the light
    std::uint32_t light = 0;
    LightRay ray;          // to the last of them
    SampledSpectrum seen;  // incident radiance times importance
};

struct Subpath {
    std::vector<SubpathVertex> vertices;
    std::vector<LightHit> lights;

    void clear() {
        vertices.clear();
        lights.clear();
    }
};

/// The scattering of a vertex from its subpath into a direction.
struct Scattered {
    SampledSpectrum weight;  // bsdf times cosine of the flux, shading-normal correction included
    DirectionDensities leaving;
    float cosine = 0;  // with the geometric normal
};

/// Evaluates a vertex that is not specular. @param way  unit, world. @param transport  of its own
/// subpath.
Scattered scattered(const SubpathVertex& vertex, const Vec3& way, Transport transport);

/// Returns the densities of light `number` for a surface at the other end of the ray.
EndDensities end_densities(const Scene& scene, std::uint32_t number, const LightRay& ray,
                           const Hit& at);

/// Traces subpaths; each thread has one and reuses it.
class SubpathTracer {
public:
    /// @param light_paths  see first_of_camera(). References are kept.
    SubpathTracer(const ReferencePass& pass, const Projection& camera, double light_paths)
        : pass_(pass), camera_(camera), light_paths_(light_paths) {}

    /// Traces from the camera. @param film  in pixels. @param wavelength  hero wavelength for
    /// dispersion.
    void trace_camera(const Vec2d& film, std::size_t wavelength, PathNumbers& numbers,
                      Subpath& path);
    /// Traces from a light selected by power; the path is empty if no light has power.
    void trace_light(std::size_t wavelength, PathNumbers& numbers, Subpath& path);

    std::uint64_t rays() const { return rays_; }

private:
    void follow(PathNumbers& numbers, Subpath& path);
    bool next_surface(Subpath& path);
    void note_lights(bool met, Subpath& path);
    SubpathVertex vertex_at_hit(const Subpath& path);
    bool scatter(PathNumbers& numbers, SubpathVertex& vertex, std::size_t depth);
    float survival(const SampledSpectrum& before) const;

    const ReferencePass& pass_;
    const Projection& camera_;
    double light_paths_;
    std::uint64_t rays_ = 0;

    // The current path.
    Transport transport_ = Transport::radiance;
    SampledSpectrum throughput_;
    HeroWavelength hero_;
    MediumNumber medium_ = 0;
    Vec3 direction_{0};
    Vec3 from_{0};  // origin of the ray
    RayHit ray_hit_;
    Hit hit_;
    float unlit_ = 0;
    float lit_to_ = kInfinity;
    float scale_ = 1;  // squared ratio of indices, for Russian roulette
    Vec2d lens_{0};
    std::uint32_t light_ = 0;
    LightRay start_;  // or the camera ray
};

}  // namespace sunfleck::engine
