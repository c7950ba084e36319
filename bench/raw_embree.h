// Embree alone: the yardstick of the benchmarks.
//
// In:  recorded rays. Out: how long Embree takes for them, on the very tree that the renderer
// uses (same device, same build, same kernels), with nothing computed about the hits.
#pragma once

#include "geometry/built.h"
#include "scene/scene.h"

#include <vector>

namespace sunfleck::bench {

struct RecordedRay {
    Ray ray;
    bool shadow = false;  // asks for occlusion
};

class RawEmbree {
public:
    /// @param scene  without instances; must outlive this.
    explicit RawEmbree(const Scene& scene);

    /// Traces all on the threads that the limit allows. @return how many met something.
    std::size_t trace(const std::vector<RecordedRay>& rays) const;

private:
    std::size_t trace_block(const RecordedRay* begin, const RecordedRay* end) const;

    embree::Device device_;
    std::vector<BuiltShape::Corners> counting_;
    std::vector<BuiltShape> shapes_;
    ShapeGroup world_;
};

/// The rays of the photon pass `pass`: those that met a surface.
/// @param paths  photon paths. @param scene  diffuse surfaces alone.
std::vector<RecordedRay> photon_rays(const Scene& scene, std::uint32_t paths, PassId pass);

/// For each pixel what an eye path traces at a diffuse surface: the camera ray, a shadow ray to a
/// light, and a ray by the cosine.
std::vector<RecordedRay> eye_rays(const Scene& scene, PassId pass);

}  // namespace sunfleck::bench
