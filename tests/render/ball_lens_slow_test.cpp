// Sunlight through a ball of glass onto a screen, against a quadrature of Snell's and Fresnel's
// laws in the plane of incidence: a caustic without free parameters.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kEta = 1.5;
constexpr double kScreen = -4;  // height; the ball of radius 1 is at the origin, its focus at -1.5
constexpr double kEye = -1.1;   // height of the camera, on the axis, looking down
constexpr double kAlbedo = 0.5;
constexpr double kHalfView = 0.8;  // half width of the picture on the screen

double fresnel(double cos_near, double cos_far, double eta) {
    const double s = (cos_near - eta * cos_far) / (cos_near + eta * cos_far);
    const double p = (eta * cos_near - cos_far) / (eta * cos_near + cos_far);
    return 0.5 * (s * s + p * p);
}

/// Irradiance on the screen by distance from the axis, for a sun of irradiance one: all light that
/// the ball sends there. Grazing light that goes round the ball many times meets at the axis.
class ScreenIrradiance {
public:
    /// @param chords  light crosses the ball at most so many times.
    explicit ScreenIrradiance(int chords) : chords_(chords), flux_(kBins) {
        constexpr int kRays = 2'000'000;
        for (int i = 0; i < kRays; ++i) {
            const double b = (i + 0.5) / kRays;
            trace(b, 2 * kPiDouble * b / kRays);
        }
        for (std::size_t i = 0; i < kBins; ++i) {
            const auto at = static_cast<double>(i);
            flux_[i] /= kPiDouble * (2 * at + 1) * kWidth * kWidth;
        }
    }

    double operator()(double r) const { return flux_.at(static_cast<std::size_t>(r / kWidth)); }

    /// Mean over a disc of this radius, its centre at distance r: what a density estimate shows.
    double blurred(double r, double radius) const {
        constexpr int kSteps = 24;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const double rho = radius * std::sqrt((i + 0.5) / kSteps);
                const double phi = 2 * kPiDouble * (j + 0.5) / kSteps;
                sum += (*this)(std::hypot(r + rho * std::cos(phi), rho * std::sin(phi)));
            }
        }
        return sum / (kSteps * kSteps);
    }

private:
    static constexpr std::size_t kBins = 1000;
    static constexpr double kWidth = 0.002;

    /// A ray at distance b from the axis, downwards. Angles: i outside, t inside; a point of the
    /// ball and a direction are angles in the plane of incidence.
    void trace(double b, double flux) {
        const double cos_i = std::sqrt(1 - b * b);
        const double cos_t = std::sqrt(1 - b * b / (kEta * kEta));
        const double reflected = fresnel(cos_i, cos_t, kEta);
        const double i = std::asin(b);
        const double t = std::asin(b / kEta);
        land(i, 2 * i, flux * reflected);  // upwards, mirrored about the normal at angle i
        double inside = flux * (1 - reflected);
        double point = i;  // from the upward axis
        for (int chord = 0; chord < chords_; ++chord) {
            point += kPiDouble - 2 * t;                        // a chord later
            land(point, point + i, inside * (1 - reflected));  // leaves at angle i to the normal
            inside *= reflected;
        }
    }

    /// A ray that leaves the ball's surface at `point` in a direction, both as angles from +z.
    void land(double point, double direction, double flux) {
        const double down = -std::cos(direction);
        if (down <= 0) return;
        const double distance = (std::cos(point) - kScreen) / down;
        const double r = std::abs(std::sin(point) + distance * std::sin(direction));
        if (r < kWidth * kBins) flux_[static_cast<std::size_t>(r / kWidth)] += flux;
    }

    int chords_;
    std::vector<double> flux_;
};

Scene ball_lens() {
    const double fov = 2 * std::atan(kHalfView / (kEye - kScreen)) * 180 / kPiDouble;
    return scene_of(view("0 0 -1.1  0 0 -4  0 1 0", fov, 16) +
                    "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n" +
                    diffuse("0.5 0.5 0.5") +
                    quad("-1.5 -1.5 -4  1.5 -1.5 -4  1.5 1.5 -4  -1.5 1.5 -4") +
                    "Material \"dielectric\" \"float eta\" 1.5\nShape \"sphere\"\n");
}

/// Irradiance in three rings of pixels, over independent renders: caustic light alone.
struct Rings {
    static constexpr std::size_t kRings = 3;
    std::array<std::vector<double>, kRings> seen;
    std::array<double, kRings> blurred{};
    std::array<double, kRings> sharp{};

    /// @param chords  light crosses the ball at most so many times.
    Rings(double radius, int renders, int chords) {
        const Scene scene = ball_lens();
        RenderSettings settings;
        settings.camera.radius = radius;
        settings.transport.max_depth = chords + 2;
        settings.alpha = 0.999999;                         // one radius for all passes
        settings.photon.sampler = PhotonSampler::uniform;  // quieter than chains in so wide a view
        settings.photon.paths_per_pass = 100'000;
        settings.aovs[static_cast<std::size_t>(Aov::caustic)] = true;
        for (int i = 0; i < renders; ++i) {
            settings.seed = static_cast<std::uint64_t>(i);
            const MeanPicture picture = render_mean(scene, settings, 16, Aov::caustic);
            std::array<double, kRings> sum{};
            std::array<int, kRings> count{};
            for_pixels([&](int x, int y, std::size_t ring) {
                sum.at(ring) += luminance(picture.at(x, y)) * kPiDouble / kAlbedo;
                ++count.at(ring);
            });
            for (std::size_t r = 0; r < kRings; ++r) seen.at(r).push_back(sum.at(r) / count.at(r));
        }
        expect(radius, ScreenIrradiance(chords));
    }

private:
    /// Position on the screen, in units of a pixel from the axis.
    template <class F>
    static void for_pixels(const F& visit) {
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                const double r = std::hypot(x - 7.5, y - 7.5);
                if (r < 8) visit(x, y, r < 4 ? 0 : r < 6 ? 1 : 2);
            }
        }
    }

    void expect(double radius, const ScreenIrradiance& irradiance) {
        constexpr int kSub = 4;
        std::array<int, kRings> count{};
        for_pixels([&](int x, int y, std::size_t ring) {
            if (x < 8 || y < 8) return;  // by symmetry
            ++count.at(ring);
            for (int s = 0; s < kSub * kSub; ++s) {
                const int column = s % kSub;
                const int row = s / kSub;
                const double px = (x - 8 + (column + 0.5) / kSub) * kHalfView / 8;
                const double py = (y - 8 + (row + 0.5) / kSub) * kHalfView / 8;
                const double r = std::hypot(px, py);
                sharp.at(ring) += irradiance(r) / (kSub * kSub);
                blurred.at(ring) += irradiance.blurred(r, radius) / (kSub * kSub);
            }
        });
        for (std::size_t r = 0; r < kRings; ++r) {
            sharp.at(r) /= count.at(r);
            blurred.at(r) /= count.at(r);
        }
    }
};

/// In every ring, with 99% confidence, within 1% of the quadrature (blurred by the disc).
TEST(BallLens, rings_agree_with_quadrature) {
    const Rings rings(0.05, 12, 30);
    for (std::size_t r = 0; r < Rings::kRings; ++r) {
        const Estimate seen = Estimate::of(rings.seen.at(r));
        EXPECT_LT(worst_ratio(seen, {rings.blurred.at(r), 0}), 0.01)
            << r << ": " << seen.mean << " +- " << seen.error << ", " << rings.blurred.at(r);
    }
}

/// Wide discs show a bias of order r^2, which two radii extrapolate away. (One crossing only: what
/// meets at the axis is no smooth function there.)
TEST(BallLens, radius_bias_is_quadratic) {
    const double wide = 0.4;
    const double narrow = 0.28;
    const Rings at_wide(wide, 8, 1);
    const Rings at_narrow(narrow, 8, 1);
    std::vector<double> extrapolated;
    for (std::size_t i = 0; i < 8; ++i)
        extrapolated.push_back(
            (wide * wide * at_narrow.seen[0][i] - narrow * narrow * at_wide.seen[0][i]) /
            (wide * wide - narrow * narrow));
    const Estimate biased = Estimate::of(at_wide.seen[0]);
    const double truth = at_wide.sharp[0];
    EXPECT_GT(std::abs(biased.mean / truth - 1), 0.03) << biased.mean << ' ' << truth;
    EXPECT_LT(worst_ratio(Estimate::of(extrapolated), {truth, 0}), 0.015)
        << Estimate::of(extrapolated).mean << " for " << truth;
    EXPECT_LT(worst_ratio(biased, {at_wide.blurred[0], 0}), 0.01);
}

}  // namespace
}  // namespace sunfleck::engine
