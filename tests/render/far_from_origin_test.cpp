// A scene far from the origin, and a camera far from the scene: the same light as near it. A scene
// of floats alone loses its caustic at 10^4 sizes, and all of it beyond.
#include "support/renders.h"

#include <gtest/gtest.h>

#include <iomanip>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

enum class By { transform, vertices, instance };

std::string three(const Vec3d& p) {
    std::ostringstream text;
    text << std::setprecision(17) << p.x << ' ' << p.y << ' ' << p.z << "  ";
    return text.str();
}

std::string square(const Vec3d& middle, double half) {
    std::string corners;
    for (const Vec3d& c : {Vec3d(-1, -1, 0), Vec3d(1, -1, 0), Vec3d(1, 1, 0), Vec3d(-1, 1, 0)})
        corners += three(middle + c * half);
    return quad(corners);
}

/// An icosahedron subdivided: a ball of glass. (Its triangles run counter-clockwise.)
std::string ball(const Vec3d& center) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::string points;
    for (const Vec3d& p : {Vec3d(-1, g, 0), Vec3d(1, g, 0), Vec3d(-1, -g, 0), Vec3d(1, -g, 0),
                           Vec3d(0, -1, g), Vec3d(0, 1, g), Vec3d(0, -1, -g), Vec3d(0, 1, -g),
                           Vec3d(g, 0, -1), Vec3d(g, 0, 1), Vec3d(-g, 0, -1), Vec3d(-g, 0, 1)})
        points += three(center + p * 0.6);
    return "ReverseOrientation\nShape \"loopsubdiv\" \"integer levels\" 3 \"point3 P\" [" + points +
           "] \"integer indices\" [0 11 5 0 5 1 0 1 7 0 7 10 0 10 11 1 5 9 5 11 4 11 10 2 10 7 6 "
           "7 1 8 3 9 4 3 4 2 3 2 6 3 6 8 3 8 9 4 9 5 2 4 11 6 2 10 8 6 7 9 8 1]\n"
           "ReverseOrientation\n";
}

/// A glass ball on a plain in the sun, 12 across, around `place`. @param away  of the camera.
Scene glass_at(const Vec3d& place, By by, double away = 8, int pixels = 24) {
    const Vec3d own = by == By::transform ? Vec3d(0) : place;
    std::string body = "Material \"dielectric\" \"float eta\" 1.5\n" + ball(own + Vec3d(0, 0, 1)) +
                       diffuse("0.6 0.6 0.6") + square(own, 6);
    if (by == By::transform)
        body = "AttributeBegin\nTranslate " + three(place) + "\n" + body + "AttributeEnd\n";
    if (by == By::instance)
        body = "ObjectBegin \"all\"\n" + body + "ObjectEnd\nObjectInstance \"all\"\n";
    const double fov = 2 * std::atan(2.5 / away) * 180 / kPiDouble;
    std::ostringstream fov_text;
    fov_text << std::setprecision(17) << fov;
    return scene_of("LookAt " + three(place + Vec3d(0.48, -0.6, 0.64) * away) + three(place) +
                    "0 0 1\nCamera \"perspective\" \"float fov\" " + fov_text.str() + "\n" +
                    film(pixels) +
                    "WorldBegin\nLightSource \"distant\" \"point3 from\" [-1 1 3] "
                    "\"point3 to\" [0 0 0]\nLightSource \"infinite\" \"rgb L\" [.1 .1 .1]\n" +
                    body);
}

/// Where pixels' rays meet the scene, relative to `place`; nothing met: far away.
std::vector<Vec3d> seen(const Scene& scene, const Vec3d& place) {
    std::vector<Vec3d> points;
    const Vec2i size = scene.film().resolution;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const CameraRay ray = camera_ray(scene.camera(), {x + 0.5, y + 0.5}, {0.5, 0.5});
            const auto hit = scene.first_hit(ray);
            points.push_back(hit ? Vec3d(hit->position) + scene.origin() - place : Vec3d(1e30));
        }
    return points;
}

/// Within so much, but for few pixels at edges.
void expect_same(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b, double within) {
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) apart += (a[i] - b[i]).length() > within ? 1 : 0;
    EXPECT_LE(apart, a.size() / 100);
}

struct Place {
    Vec3d at;
    double within;  // what doubles at that place allow
};

const std::vector<Place>& places() {
    static const std::vector<Place> all = {{{5e4, 5e4, 0}, 1e-5},
                                           {{5e5, 4.5e6, 300}, 1e-5},
                                           {{12e6, -12e6, 1}, 1e-5},
                                           {{12e8, 12e8, 12e8}, 1e-4}};
    return all;
}

TEST(FarFromOrigin, surfaces_are_met_where_they_are_however_the_scene_is_moved) {
    const std::vector<Vec3d> near_it = seen(glass_at(Vec3d(0), By::transform), Vec3d(0));
    for (const By by : {By::transform, By::vertices, By::instance})
        for (const Place& place : places()) {
            SCOPED_TRACE(::testing::Message() << "by " << static_cast<int>(by) << ", " << place.at);
            const Scene scene = glass_at(place.at, by);
            EXPECT_LT((scene.origin() - place.at).length(), 20);
            EXPECT_LT(scene.geometry().bounds().radius(), 9);
            expect_same(seen(scene, place.at), near_it, place.within);
        }
}

TEST(FarFromOrigin, a_scene_near_the_origin_stays_where_it_is) {
    for (const By by : {By::transform, By::vertices, By::instance})
        EXPECT_EQ(glass_at({20, -30, 5}, by).origin(), Vec3d(0));
}

TEST(FarFromOrigin, a_long_lens_from_afar_sees_each_pixel_where_it_should) {
    const std::vector<Vec3d> flat = seen(glass_at(Vec3d(0), By::transform, 1e4), Vec3d(0));
    for (const double away : {1e5, 1e7})
        expect_same(seen(glass_at(Vec3d(0), By::transform, away), Vec3d(0)), flat, 3e-3);
}

double brightest(const MeanPicture& picture) {
    double most = 0;
    for (const Vec3d& rgb : picture.rgb) most = std::max(most, luminance(rgb));
    return most;
}

/// Sizes of the scene: 12 across.
TEST(FarFromOrigin, a_long_lens_from_a_million_sizes_away_takes_the_same_picture) {
    RenderSettings settings;
    settings.photon.paths_per_pass = 20000;
    settings.transport.indirect = IndirectLight::photons;
    const auto from = [&](double sizes) {
        return render_mean(glass_at(Vec3d(0), By::transform, 12 * sizes), settings, 4);
    };
    const MeanPicture near_it = from(1e3);
    for (const double sizes : {1e5, 1e6}) {
        const MeanPicture afar = from(sizes);
        EXPECT_NEAR(luminance(afar.mean()) / luminance(near_it.mean()), 1, 0.01);
        EXPECT_NEAR(brightest(afar) / brightest(near_it), 1, 0.15);
        for (const Count count : {Count::camera_rays, Count::photon_rays})
            EXPECT_NEAR(double(afar.statistics[count]) / double(near_it.statistics[count]), 1,
                        0.02);
    }
}

TEST(FarFromOrigin, the_caustic_is_as_bright_and_costs_as_many_rays) {
    RenderSettings settings;
    settings.photon.paths_per_pass = 20000;
    const MeanPicture near_it = render_mean(glass_at(Vec3d(0), By::vertices), settings, 4);
    const MeanPicture far_off = render_mean(glass_at({5e5, 4.5e6, 0}, By::vertices), settings, 4);
    EXPECT_GT(brightest(near_it), 3 * luminance(near_it.mean()));
    EXPECT_NEAR(luminance(far_off.mean()) / luminance(near_it.mean()), 1, 0.02);
    EXPECT_NEAR(brightest(far_off) / brightest(near_it), 1, 0.15);
    for (const Count count : {Count::camera_rays, Count::photon_rays})
        EXPECT_NEAR(double(far_off.statistics[count]) / double(near_it.statistics[count]), 1, 0.1);
}

/// The checkerboard has a frame of its own: cells of 1 around whole numbers of the world.
TEST(FarFromOrigin, textures_and_masks_go_on_seeing_the_world) {
    const Vec3d place(500000.25, 4500000.5, 0);
    const auto floor = [&](const std::string& use) {
        return scene_of("LookAt " + three(place + Vec3d(0, 0, 5)) + three(place) + "0 1 0\n" +
                        "Camera \"perspective\"\n" + film(4) +
                        "WorldBegin\nTranslate 500000 4500000 0\nTexture \"cells\" \"float\" "
                        "\"checkerboard\" \"string mapping\" "
                        "\"planar\" \"float tex1\" 1 \"float tex2\" 0\nIdentity\n" +
                        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [" +
                        three(place + Vec3d(-4, -4, 0)) + three(place + Vec3d(4, -4, 0)) +
                        three(place + Vec3d(4, 4, 0)) + three(place + Vec3d(-4, 4, 0)) + "] " +
                        use);
    };
    const Scene scene = floor("\"texture alpha\" \"cells\"\n");
    for (const double x : {-1.5, -0.5, 0.5, 1.5})
        for (const double y : {-1.6, -0.6, 0.6, 1.6}) {
            const Vec3d at = place + Vec3d(x, y, 0);
            const double parity = std::floor(at.x) + std::floor(at.y);
            const bool there = std::fmod(parity, 2) == 0;
            const Vec3 from(at + Vec3d(0, 0, 1) - scene.origin());
            EXPECT_EQ(scene.geometry().intersect({from, {0, 0, -1}}).has_value(), there)
                << at.x << ' ' << at.y;
        }
}

}  // namespace
}  // namespace sunfleck::engine
