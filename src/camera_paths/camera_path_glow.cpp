// Light that media emit, seen along the rays of a camera path.
//
// Photons bring it to the first surface or point of a medium that gathers, however far it has come;
// so the ray that leaves that one sees none of it. Later ones do.
#include "camera_paths/camera_path.h"

namespace sunfleck::engine {

void CameraPath::add_glow(const SampledMedium& medium, const Ray& way, BatchPoints& numbers) {
    const auto u = static_cast<float>(numbers.next());
    if (beyond_ && (events_beyond_ < 2 || emitters_ == Emitters::none)) return;
    const SampledSpectrum light = glow_along(medium, pass_.scene.wavelengths, way, throughput_, u);
    if (light.is_zero()) return;
    if (LightContributions* parts = wanted_contributions())
        parts->push_back({pass_.scene.light_of(medium_), light});
    add_light(light, 1, owner_of_emission());
}

}  // namespace sunfleck::engine
