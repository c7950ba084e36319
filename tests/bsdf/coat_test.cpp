// A clear coat over a diffuse base: against Stokes's relations, and against random walks.
#include "bsdf/coated_diffuse.h"
#include "core/random.h"
#include "math/warp.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Mean over evenly spread light.
template <class F>
double mean_over_angles(const F& f) {
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        sum += static_cast<double>(f(std::sqrt((static_cast<float>(i) + 0.5F) / kSteps)));
    return sum / kSteps;
}

/// What even light loses on its way in it loses on its way out, over eta^2.
TEST(Coat, lets_as_much_in_as_out) {
    for (const float eta : {1.2F, 1.5F, 2.4F}) {
        const Coat coat(eta, {}, 0);
        const double in = mean_over_angles([&](float c) { return coat.entering(c); });
        EXPECT_NEAR(coat.mean_entering(), in, 1e-3);
        EXPECT_NEAR(1 - coat.returning(), in / (eta * eta), 2e-4) << eta;
    }
}

/// A white base under a clear coat sends everything back.
TEST(Coat, white_under_smooth_glass_loses_nothing) {
    const Coat coat(1.5F, {}, 0);
    for (const float cosine : {1.0F, 0.7F, 0.3F, 0.05F}) {
        const CoatedBase base{SampledSpectrum(1), &coat};
        const Vec3 w(std::sqrt(1 - cosine * cosine), 0, cosine);
        EXPECT_NEAR(base.diffuse_albedo(w)[0] + coat.reflectance(cosine), 1, 3e-4) << cosine;
    }
}

TEST(Coat, an_index_of_one_is_no_coat) {
    const Coat coat(1, {}, 0);
    const CoatedDiffuse plain{SampledSpectrum(0.6F), &coat};
    const Vec3 a(0.6F, 0, 0.8F);
    const Vec3 b(0, 0.8F, 0.6F);
    EXPECT_NEAR(plain.eval(a, b, Transport::radiance)[0], 0.6F / kPi, 1e-4F);
}

/// One photon's walk between a rough or smooth boundary and a diffuse base, event by event.
/// @return the direction in which it leaves, or nothing when it is lost.
class Walk {
public:
    Walk(const Coat& coat, float thickness, float albedo, std::uint32_t seed)
        : coat_(coat), thickness_(thickness), albedo_(albedo), random_(seed, Purpose::test, 0, 0) {}

    std::optional<Vec3> run(const Vec3& w) {
        auto entered = cross(w, coat_.eta());
        if (!entered || entered->z > 0) return entered;
        Vec3 down = *entered;
        while (true) {
            if (lost(-down.z) || random_.next_float() >= albedo_) return {};
            const Vec3d up = cosine_hemisphere(Vec2d(random_.next(), random_.next()));
            if (lost(static_cast<float>(up.z))) return {};
            // Seen from below: turned over.
            const auto met = cross(Vec3(Vec3d(up.x, -up.y, up.z)), 1 / coat_.eta());
            if (!met) return {};
            if (met->z < 0) return Vec3(met->x, -met->y, -met->z);
            down = Vec3(met->x, -met->y, -met->z);
        }
    }

private:
    bool lost(float cosine) { return random_.next_float() >= std::exp(-thickness_ / cosine); }

    /// @param w  towards where the photon comes from, above. @return where it goes.
    std::optional<Vec3> cross(const Vec3& w, float far_over_near) {
        Vec3 h(0, 0, 1);
        if (coat_.facets())
            h = coat_.facets()->sample_visible(w, random_.next_float(), random_.next_float());
        const float c = std::min(1.0F, w.dot(h));
        if (!(c > 0)) return {};
        const float far = refracted_cosine(1 - c * c, far_over_near);
        const bool reflects =
            random_.next_float() < dielectric_reflectance(c, far, far_over_near) || far == 0;
        const Vec3 to = reflects ? h * (2 * c) - w
                                 : (h * (c / far_over_near - far) - w / far_over_near).normalized();
        if ((to.z > 0) != reflects) return {};
        const float kept = coat_.facets() ? coat_.facets()->shadowing_given_masking(w, to) : 1.0F;
        if (random_.next_float() >= kept) return {};
        return to;
    }

    const Coat& coat_;
    float thickness_;
    float albedo_;
    RandomStream random_;
};

struct Case {
    std::optional<Ggx> facets;
    float thickness;
    float albedo;
    double band;  // relative, in each of four rings of the cosine
};

/// Light sent back in four rings of equal probability of a cosine lobe. 400,000 walks: the error of
/// a ring is about 0.5%.
TEST(Coat, agrees_with_random_walks) {
    constexpr int kWalks = 400'000;
    constexpr std::size_t kRings = 4;
    const auto ring_of = [](const Vec3& w) {
        return std::min(kRings - 1, static_cast<std::size_t>(kRings * w.z * w.z));
    };
    for (const Case& c : {Case{{}, 0, 0.9F, 0.02}, Case{{}, 0.2F, 0.5F, 0.02},
                          Case{Ggx{0.3F, 0.3F}, 0.05F, 0.8F, 0.03}})
        for (const float cosine : {0.95F, 0.4F}) {
            const Coat coat(1.5F, c.facets, c.thickness);
            const CoatedBase base{SampledSpectrum(c.albedo), &coat};
            const CoatReflection top{&coat};
            const Vec3 w(std::sqrt(1 - cosine * cosine), 0, cosine);
            Walk walk(coat, c.thickness, c.albedo, 5);
            std::array<double, kRings> walked{};
            for (int i = 0; i < kWalks; ++i) {
                const auto out = walk.run(w);
                const bool mirrored =
                    out && !c.facets && std::abs(out->x + w.x) < 1e-6F && out->y == 0;
                if (out && !mirrored) walked.at(ring_of(*out)) += 1.0 / kWalks;
            }
            RandomStream random(6, Purpose::test, 0, 0);
            std::array<double, kRings> formula{};
            for (int i = 0; i < kWalks; ++i) {
                const Vec3 to(cosine_hemisphere(Vec2d(random.next(), random.next())));
                SampledSpectrum f = base.eval(w, to, Transport::flux);
                if (c.facets) f += top.eval(w, to, Transport::flux);
                formula.at(ring_of(to)) += static_cast<double>(f[0] * kPi) / kWalks;
            }
            for (std::size_t r = 0; r < kRings; ++r)
                EXPECT_NEAR(walked.at(r) / formula.at(r), 1, c.band)
                    << "cosine " << cosine << ", ring " << r << ", thickness " << c.thickness;
        }
}

}  // namespace
}  // namespace sunfleck::engine
