// Quadrature over where and how light meets a clear cylinder.
#include "material/fibre_albedo.h"

#include "bsdf/fresnel.h"
#include "math/warp.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Light at one offset from the axis. @param cosine, sine  of the angle to the normal plane.
/// @param offset  in (0,1) of the radius.
FibreAlbedo at_offset(float absorption, float eta, const Vec2& cosine_sine, float offset) {
    const auto [cosine, sine] = std::pair(cosine_sine.x, cosine_sine.y);
    const float across = std::sqrt(1 - offset * offset);
    const float reflected = dielectric_reflectance(cosine * across, eta);
    // The projected path bends as by Bravais's index.
    const float bravais = std::sqrt(std::max(0.0F, eta * eta - sine * sine)) / cosine;
    if (!(bravais > offset)) return {1, 0};  // an index below that around it: reflected totally
    const float inner = offset / bravais;
    const float chord = 2 * std::sqrt(1 - inner * inner);
    const float slope = std::sqrt(std::max(1e-6F, 1 - sine * sine / (eta * eta)));
    const float left = std::exp(-absorption * chord / slope);
    const float through = (1 - reflected) * (1 - reflected) * left;
    const float again = left * reflected;  // of what stays within, on each further way
    const float later = again < 1 ? through * again / (1 - again) : 0;
    return {reflected + later, through};
}

}  // namespace

FibreAlbedo fibre_albedo(float absorption, float eta) {
    constexpr int kSteps = 32;
    FibreAlbedo sum;
    float weights = 0;
    for (int i = 0; i < kSteps; ++i) {
        const float angle = (static_cast<float>(i) + 0.5F) / kSteps * (kPi / 2);
        const Vec2 cosine_sine(std::cos(angle), std::sin(angle));
        const float weight = cosine_sine.x * cosine_sine.x;  // solid angle, and width as seen
        for (int j = 0; j < kSteps; ++j) {
            const float offset = (static_cast<float>(j) + 0.5F) / kSteps;
            const FibreAlbedo here = at_offset(absorption, eta, cosine_sine, offset);
            sum.back += weight * here.back;
            sum.through += weight * here.through;
            weights += weight;
        }
    }
    return {sum.back / weights, sum.through / weights};
}

float absorption_of_hair(float colour, float beta) {
    // Chiang et al. 2016, equation 9.
    const float b2 = beta * beta;
    const float fit = 5.969F - 0.215F * beta + 2.532F * b2 - 10.73F * b2 * beta + 5.574F * b2 * b2 +
                      0.245F * b2 * b2 * beta;
    const float root = std::log(colour) / fit;
    return root * root;
}

}  // namespace sunfleck::engine
