// Microfacets of the GGX (Trowbridge-Reitz) distribution, with a width along x and one along y.
//
// Source: Walter et al., Microfacet Models for Refraction through Rough Surfaces (EGSR 2007);
// Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs (JCGT 2014);
// Heitz, Sampling the GGX Distribution of Visible Normals (JCGT 2018).
//
// Masking and shadowing are height-correlated in the sum form G2 = 1 / (1 + L(a) + L(b)) for
// reflection and transmission alike, as in pbrt-v4. With s(w) = sqrt(z^2 + (ax x)^2 + (ay y)^2)
// Smith's L(w) = (s / |z| - 1) / 2, and every quotient below stays finite at grazing angles.
#pragma once

#include "math/vector.h"
#include "math/warp.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

struct Ggx {
    float alpha_x = 0.1F;  // positive
    float alpha_y = 0.1F;

    /// D(h), per steradian; the same for h and -h. @param h  unit.
    float density(const Vec3& h) const {
        const float x = h.x / alpha_x;
        const float y = h.y / alpha_y;
        const float t = x * x + y * y + h.z * h.z;
        return 1 / (kPi * alpha_x * alpha_y * t * t);
    }

    /// s(w) of the head comment.
    float stretched_length(const Vec3& w) const {
        const float x = alpha_x * w.x;
        const float y = alpha_y * w.y;
        return std::sqrt(w.z * w.z + x * x + y * y);
    }

    /// G2(a, b) / (|a.z| |b.z|).
    float shadowing_over_cosines(const Vec3& a, const Vec3& b) const {
        return 2 / (stretched_length(a) * std::abs(b.z) + stretched_length(b) * std::abs(a.z));
    }

    /// G2(a, b) / G1(a), in [0,1]: what is left to b of the facets that a sees.
    float shadowing_given_masking(const Vec3& a, const Vec3& b) const {
        const float s = stretched_length(a);
        const float z = std::abs(b.z);
        return z * (std::abs(a.z) + s) / (s * z + stretched_length(b) * std::abs(a.z));
    }

    /// Density of the normals that w sees, divided by |w.h|: G1(w) D(h) / |w.z|.
    float visible_density_over_cosine(const Vec3& w, const Vec3& h) const {
        return 2 * density(h) / (std::abs(w.z) + stretched_length(w));
    }

    /// A normal that w sees, with density G1(w) D(h) (w.h) / w.z; h.z >= 0.
    /// @param w  unit, w.z > 0. @param u, v  in [0,1].
    Vec3 sample_visible(const Vec3& w, float u, float v) const {
        // The stretched view of a hemisphere, and a frame of its disc.
        const Vec3 view = Vec3(alpha_x * w.x, alpha_y * w.y, w.z).normalized();
        const float flat2 = view.x * view.x + view.y * view.y;
        const float flat = std::sqrt(flat2);
        const Vec3 t1 = flat2 > 1e-30F ? Vec3(-view.y / flat, view.x / flat, 0) : Vec3(1, 0, 0);
        const Vec3 t2 = view.cross(t1);

        // A point of the disc, squeezed into the part that is seen, lifted to the hemisphere.
        const Vec2 p(concentric_disc(Vec2d(u, v)));
        const float half_width = std::sqrt(std::max(0.0F, 1 - p.x * p.x));
        const float s = 0.5F * (1 + view.z);
        const float y = (1 - s) * half_width + s * p.y;
        const float lift = std::sqrt(std::max(0.0F, 1 - p.x * p.x - y * y));
        const Vec3 seen = t1 * p.x + t2 * y + view * lift;

        const Vec3 h(alpha_x * seen.x, alpha_y * seen.y, std::max(1e-6F, seen.z));
        return h.normalized();
    }
};

}  // namespace sunfleck::engine
