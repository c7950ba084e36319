// A hole of one millimetre over a plain of ten kilometres in the sun: photons and camera paths both
// find it where it is, as bright as it should be.
#include "photon/tracer.h"
#include "random_numbers/emission_points.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kHoleX = 3.0;  // corner of the hole, metres
constexpr double kHoleY = 2.0;
constexpr double kHole = 1e-3;
constexpr double kScreen = 0.01;  // height
constexpr double kSun = 5;        // irradiance

/// A sheet of 20 cm with a square hole, 1 cm over the ground.
std::string screen() {
    const auto part = [](double x0, double x1, double y0, double y1) {
        std::ostringstream text;
        text << x0 << ' ' << y0 << ' ' << kScreen << "  " << x1 << ' ' << y0 << ' ' << kScreen
             << "  " << x1 << ' ' << y1 << ' ' << kScreen << "  " << x0 << ' ' << y1 << ' '
             << kScreen;
        return quad(text.str());
    };
    const double x1 = kHoleX + kHole;
    const double y1 = kHoleY + kHole;
    return part(kHoleX - 0.1, kHoleX, kHoleY - 0.1, kHoleY + 0.1) +
           part(x1, x1 + 0.1, kHoleY - 0.1, kHoleY + 0.1) + part(kHoleX, x1, kHoleY - 0.1, kHoleY) +
           part(kHoleX, x1, y1, kHoleY + 0.1);
}

/// The camera is below the screen and looks at the ground under the hole: 2.5 mm across.
Scene plain() {
    const double fov = 2 * std::atan(1.25 / 8) * 180 / kPiDouble;
    return scene_of(view("3.0005 2.0005 .008  3.0005 2.0005 0  0 1 0", fov, 25) +
                    "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0] "
                    "\"float scale\" 5\n" +
                    diffuse("0.5 0.5 0.5") +
                    quad("-5000 -5000 0  5000 -5000 0  5000 5000 0  -5000 5000 0") + screen());
}

/// Dimensions of photon paths that start above a small patch: the emission dimensions move in a
/// window of the given width around a centre. The share of all paths is the window's area.
class Window {
public:
    Window(const Scene& scene, const Vec2d& target, double width) : width_(width) {
        for (int step = 0; step < 40; ++step) {  // secants: the guide is smooth away from diagonals
            const Vec2d at = ground(scene, center_);
            const double h = 1e-9;
            const Vec2d dx = (ground(scene, center_ + Vec2d(h, 0)) - at) / h;
            const Vec2d dy = (ground(scene, center_ + Vec2d(0, h)) - at) / h;
            const Vec2d d = target - at;
            const double det = dx.x * dy.y - dx.y * dy.x;
            center_ += Vec2d(d.x * dy.y - d.y * dy.x, dx.x * d.y - dx.y * d.x) / det;
        }
    }

    double share() const { return width_ * width_; }
    Vec2d where(const Scene& scene) const { return ground(scene, center_); }

    auto path(std::uint32_t number) const {
        return [this, stream = RandomStream(4, Purpose::test, 0, number)](
                   std::uint32_t index) mutable -> std::uint64_t {
            const std::uint64_t fraction = stream.at(index);
            if (index > dimension(EmissionDimension::position_v)) return fraction;
            const double center =
                index == dimension(EmissionDimension::position_u) ? center_.x : center_.y;
            const double u = center + (to_unit(fraction) - 0.5) * width_;
            return static_cast<std::uint64_t>(u * 0x1p52) << 12U;
        };
    }

private:
    /// Where the sun's ray from these dimensions meets the ground.
    static Vec2d ground(const Scene& scene, const Vec2d& u) {
        const Emission e = sample_emission(scene.lights()[0], {u.x, u.y, 0.5, 0.5}, scene.sphere());
        const double t = -e.origin.z / e.direction.z;
        return {e.origin.x + t * e.direction.x, e.origin.y + t * e.direction.y};
    }

    Vec2d center_{0.5002, 0.50007};
    double width_;
};

TEST(FarScale, photons_pass_a_hole_of_a_millimetre) {
    const Scene scene = plain();
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport;
    const PhotonTracer tracer(pass, transport);
    const Window window(scene, {kHoleX + kHole / 2, kHoleY + kHole / 2}, 4e-7);  // some 5 mm
    ASSERT_LT((window.where(scene) - Vec2d(kHoleX + kHole / 2, kHoleY + kHole / 2)).length(), 1e-8);
    constexpr std::uint32_t kPaths = 400'000;
    double bright = 0;  // flux within the hole's shadow, a little inside its edges
    int outside = 0;    // photons on the ground a little beyond them
    int on_ground = 0;
    constexpr double kEdge = 2e-6;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        std::uint64_t rays = 0;
        const auto visit = [&](const Photon& photon) {
            if (photon.bounces > 0 || photon.position.z > 0.005F) return;
            ++on_ground;
            const double x = static_cast<double>(photon.position.x) - kHoleX;
            const double y = static_cast<double>(photon.position.y) - kHoleY;
            if (std::min({x, y, kHole - x, kHole - y}) > kEdge)
                bright += static_cast<double>(photon.flux[0]);
            if (std::min({x, y, kHole - x, kHole - y}) < -kEdge) ++outside;
        };
        tracer.trace(window.path(i), visit, rays);
    }
    const double side = kHole - 2 * kEdge;
    const double irradiance = bright * window.share() / kPaths / (side * side) /
                              static_cast<double>(pass.emission[0][0] / kSun);
    // Some 10,000 photons pass: 3 standard errors are 3%.
    EXPECT_GT(on_ground, 5'000);
    EXPECT_NEAR(irradiance, kSun, 3 * kSun / std::sqrt(on_ground));
    EXPECT_EQ(outside, 0);
}

/// The camera's own light samples: a bright square of ten pixels, sharp to a pixel's tenth.
TEST(FarScale, camera_paths_see_the_hole_on_the_ground) {
    RenderSettings settings;
    settings.photon.paths_per_pass = 1'000;
    settings.transport.max_depth = 1;  // without what screen and ground throw to each other
    const MeanPicture picture = render_mean(plain(), settings, 16);
    const double lit = kSun * 0.5 / kPiDouble;
    double worst = 0;  // off the square's edges
    for (int y = 0; y < 25; ++y) {
        for (int x = 0; x < 25; ++x) {
            const int inside = std::min({x - 7, y - 7, 17 - x, 17 - y});
            const double expected = inside > 1 ? lit : 0;
            if (inside > 1 || inside < 0)
                worst = std::max(worst, std::abs(luminance(picture.at(x, y)) - expected));
        }
    }
    EXPECT_LT(worst, 0.001 * lit);
    // Ten by ten pixels of a tenth of a millimetre.
    EXPECT_NEAR(luminance(picture.mean()) * 625 / 100, lit, 0.01 * lit);
}

}  // namespace
}  // namespace sunfleck::engine
