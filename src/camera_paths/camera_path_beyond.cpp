// The part of a camera path beyond the first diffuse surface: path tracing of the light that leaves
// its lamp straight to a diffuse surface. Photons bring what a smooth or glossy surface sends on
// first (docs/method/method.md, which estimator brings which light). Paths do not split here.
#include "camera_paths/camera_path.h"

namespace sunfleck::engine {

/// @param vertex  the first diffuse surface.
void CameraPath::go_beyond(const CameraVertex& vertex, BatchPoints numbers) {
    beyond_ = true;
    if (scatter(vertex, numbers))
        follow(pass_.scene.scene.geometry().intersect(ray_beyond(vertex.hit)), numbers);
}

/// @param vertex  with the bsdf at the path's wavelengths. @param at_surface  at all of them.
/// @return whether the path continues, in the new direction.
bool CameraPath::interact_beyond(const CameraVertex& vertex, const Bsdf& at_surface,
                                 BatchPoints& numbers) {
    const auto* coated = std::get_if<CoatedDiffuse>(&at_surface);
    if (coated == nullptr) {
        if (scattering(vertex.bsdf) == Scattering::diffuse)
            add_direct_light(vertex, numbers, false);
        return scatter(vertex, numbers);
    }
    const Bsdf base = coated->base();
    const Bsdf top = coated->top();
    const CameraVertex below{vertex.hit, vertex.frame, vertex.wo, base, vertex.medium, vertex.ris};
    add_direct_light(below, numbers, false);
    const float chance = coated->chance_of_top(vertex.wo);
    const bool is_above = numbers.next() < double{chance};
    throughput_ /= is_above ? chance : 1 - chance;
    if (!is_above) return scatter(below, numbers);
    return scatter({vertex.hit, vertex.frame, vertex.wo, top, vertex.medium, vertex.ris}, numbers);
}

}  // namespace sunfleck::engine
