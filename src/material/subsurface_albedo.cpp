// Integrals over the places where light leaves, and over the depth of what it is scattered by.
#include "material/subsurface_albedo.h"

#include "bsdf/fresnel.h"
#include "math/warp.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kDepths = 48;
constexpr int kRings = 96;

/// Lengths are in units of one over the extinction.
struct Boundary {
    float eta = 1;
    float moment1 = 0;  // integrals of the reflectance from within times mu, and mu squared
    float moment2 = 0;
};

Boundary boundary_of(float eta) {
    constexpr int kSteps = 256;
    Boundary result{eta};
    for (int i = 0; i < kSteps; ++i) {
        const float mu = (static_cast<float>(i) + 0.5F) / kSteps;
        const float reflected = dielectric_reflectance(mu, 1 / eta);
        result.moment1 += reflected * mu / kSteps;
        result.moment2 += reflected * mu * mu / kSteps;
    }
    return result;
}

/// What leaves by many scatterings through a unit of area, of light in depth order `depths`.
class Diffusion {
public:
    Diffusion(const Boundary& boundary, float scattering, float absorption)
        : extinction_(scattering + absorption), albedo_(scattering / extinction_) {
        spread_ = (2 * absorption + scattering) / (3 * extinction_ * extinction_);
        decay_ = std::sqrt(absorption / spread_);
        beyond_ = 4 * spread_ * (1 + 3 * boundary.moment2) / (1 - 2 * boundary.moment1);
        by_fluence_ = 0.25F * (1 - 2 * boundary.moment1);
        by_flow_ = 0.5F * (1 - 3 * boundary.moment2);
    }

    /// @param path  optical depth of the source, by extinction one.
    float leaving(float ring, float path) const {
        const float depth = path / extinction_;
        const float mirrored = depth + beyond_;
        const float near = std::hypot(ring, depth);
        const float far = std::hypot(ring, mirrored);
        const float from_near = std::exp(-decay_ * near) / (4 * kPi * near);
        const float from_far = std::exp(-decay_ * far) / (4 * kPi * far);
        const float fluence = (from_near - from_far) / spread_;
        const float flow = from_near * depth * (1 + decay_ * near) / (near * near) +
                           from_far * mirrored * (1 + decay_ * far) / (far * far);
        const float settled = 1 - std::exp(-2 * extinction_ * (near + depth));
        return settled * albedo_ * albedo_ * (fluence * by_fluence_ + flow * by_flow_);
    }

private:
    float extinction_;
    float albedo_;
    float spread_;
    float decay_;
    float beyond_;
    float by_fluence_;
    float by_flow_;
};

/// What leaves after one scattering.
float leaving_at_once(const Boundary& boundary, float single, float g, const Vec2& ring_path) {
    const float ring = ring_path.x;
    const float least = ring * std::sqrt(std::max(0.0F, boundary.eta * boundary.eta - 1));
    const float depth = least + ring_path.y;
    const float way = std::hypot(ring, depth);
    const float cosine = depth / way;
    const float base = 1 + g * g + 2 * g * cosine;
    const float phase = (1 - g * g) / (4 * kPi * base * std::sqrt(base));
    const float passed = 1 - dielectric_reflectance(cosine, 1 / boundary.eta);
    return single * std::exp(-(way + least)) / (way * way) * phase * passed * cosine;
}

float leaving_in_all(const Boundary& boundary, float single, float g) {
    constexpr float kFirst = 1e-4F;
    constexpr float kGrowth = 1.2F;  // up to 3,300 mean free paths
    const Diffusion diffusion(boundary, single * (1 - g), 1 - single);
    float sum = 0;
    float ring = kFirst;
    for (int i = 0; i < kRings; ++i, ring *= kGrowth) {
        float mean = 0;
        for (int k = 0; k < kDepths; ++k) {
            const float path = -std::log(1 - (static_cast<float>(k) + 0.5F) / kDepths);
            mean += diffusion.leaving(ring, path) / kDepths +
                    leaving_at_once(boundary, single, g, {ring, path}) / kDepths;
        }
        sum += mean * 2 * kPi * ring * (ring * 0.1823216F);  // d ring = ring d log ring
    }
    return sum;
}

}  // namespace

SubsurfaceAlbedo::SubsurfaceAlbedo(float eta, float g) {
    const Boundary boundary = boundary_of(eta);
    for (int i = 1; i <= kCells; ++i) {
        const float single = -std::expm1(-kDeepest * static_cast<float>(i) / kCells);
        table_.at(static_cast<std::size_t>(i)) =
            std::clamp(leaving_in_all(boundary, single, g), 0.0F, 1.0F);
    }
}

float SubsurfaceAlbedo::operator()(float single) const {
    const float depth = single < 1 ? -std::log1p(-single) : kDeepest;
    const float place = std::clamp(depth / kDeepest, 0.0F, 1.0F) * kCells;
    const auto cell = std::min(static_cast<std::size_t>(place), std::size_t{kCells - 1});
    const float beyond = place - static_cast<float>(cell);
    return table_[cell] + (table_[cell + 1] - table_[cell]) * beyond;
}

}  // namespace sunfleck::engine
