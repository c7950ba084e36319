// Each kind of shape and light far from the origin: the picture that it gives near it. The place is
// a multiple of every step that origins are rounded to, so both scenes have the same coordinates
// when rendered, and the same paths, but for the last bits of what doubles hold there.
#include "support/renders.h"

#include <gtest/gtest.h>

#include <iomanip>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

const Vec3d kFarPlace(499968, 4500096, 320);

/// Points relative to a place, in the world's coordinates.
std::string points_at(const Vec3d& place, const std::vector<Vec3d>& points) {
    std::ostringstream text;
    text << std::setprecision(17);
    for (const Vec3d& p : points)
        text << place.x + p.x << ' ' << place.y + p.y << ' ' << place.z + p.z << '\n';
    return text.str();
}

std::string list_at(const Vec3d& place, const std::vector<Vec3d>& points) {
    return "[" + points_at(place, points) + "]\n";
}

/// A statement under a Translate of its own.
std::string translated(const Vec3d& place, const std::string& statement) {
    return "AttributeBegin\nTranslate " + points_at(place, {Vec3d(0)}) + statement +
           "\nAttributeEnd\n";
}

const std::vector<Vec3d> kSlab = {
    {-1.2, -1.1, 2.3}, {1.3, -1.2, 2.3}, {-1.2, 1.2, 1.2}, {1.3, 1.2, 1.3}};

const std::vector<Vec3d> kWave = {
    {-3.2, 0.3, 1.2}, {-1.2, 2.2, 2.3}, {1.3, -2.2, 2.2}, {3.2, 0.3, 1.3}};

std::string ply_at(const Vec3d& place) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
           "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
           "end_header\n" +
           points_at(place, kSlab) + "3 0 1 2\n3 1 3 2\n";
}

/// A floor, and what is to be seen above it. @param make  called with the place.
template <class Make>
Scene scene_at(const Vec3d& place, const Make& make) {
    const std::string text =
        "LookAt " + points_at(place, {{4, -8, 8}, {0, 0, 1}}) +
        "0 0 1\nCamera \"perspective\" \"float fov\" 45\n" + film(16) + "WorldBegin\n" +
        make(place) + diffuse(".6 .5 .4") +
        quad(points_at(place, {{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}}));
    const FileAccess ply = [&](const std::string&, const SourceLocation&) { return ply_at(place); };
    return Scene(read_pbrt_text(text, "test.pbrt", ply));
}

/// Part of the light that is elsewhere in the far picture.
template <class Make>
double light_elsewhere(const Make& make) {
    RenderSettings settings;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 2000;
    const MeanPicture near_it = render_mean(scene_at(Vec3d(0), make), settings, 4);
    const MeanPicture far_off = render_mean(scene_at(kFarPlace, make), settings, 4);
    EXPECT_GT(luminance(near_it.mean()), 0.01);
    double difference = 0;
    double light = 0;
    for (std::size_t i = 0; i < near_it.rgb.size(); ++i) {
        difference += std::abs(luminance(near_it.rgb[i] - far_off.rgb[i]));
        light += luminance(near_it.rgb[i]);
    }
    return difference / light;
}

struct Kind {
    std::string name;
    std::function<std::string(const Vec3d&)> make;
};

constexpr double kMostElsewhere = 0.005;

TEST(FarKinds, shapes_far_away_look_as_they_do_near) {
    const std::string sun =
        "LightSource \"distant\" \"point3 from\" [-1 1 3] \"point3 to\" [0 0 0]\n"
        "LightSource \"infinite\" \"rgb L\" [.1 .1 .1]\n" +
        diffuse(".8 .2 .2");
    const std::vector<Kind> kinds = {
        {"sphere", [](auto at) { return translated(at, "Shape \"sphere\" \"float zmax\" .5"); }},
        {"cylinder", [](auto at) { return translated(at, "Shape \"cylinder\" \"float zmax\" 2"); }},
        {"disk", [](auto at) { return translated(at, "Shape \"disk\" \"float height\" 1"); }},
        {"curve",
         [](auto at) {
             return "Shape \"curve\" \"string type\" \"cylinder\" \"float width\" .5 \"point3 "
                    "P\" " +
                    list_at(at, kWave);
         }},
        {"curve by a Translate",
         [](auto at) {
             return translated(
                 at, "Shape \"curve\" \"float width\" .5 \"point3 P\" " + list_at(Vec3d(0), kWave));
         }},
        {"bilinear patch",
         [](auto at) { return "Shape \"bilinearmesh\" \"point3 P\" " + list_at(at, kSlab); }},
        {"PLY file of doubles",
         [](auto) { return "Shape \"plymesh\" \"string filename\" \"slab.ply\"\n"; }},
    };
    for (const Kind& kind : kinds)
        EXPECT_LT(light_elsewhere([&](const Vec3d& at) { return sun + kind.make(at); }),
                  kMostElsewhere)
            << kind.name;
}

TEST(FarKinds, lights_far_away_shine_as_they_do_near) {
    const std::string emits = "AreaLightSource \"diffuse\" \"rgb L\" [9 8 7]\n";
    const std::vector<Vec3d> opening = {{-2, 2, 4}, {-2, -2, 4}, {2, -2, 4}, {2, 2, 4}};
    const std::vector<Kind> kinds = {
        {"point",
         [](auto at) {
             return "LightSource \"point\" \"rgb I\" [50 50 50] \"point3 from\" " +
                    list_at(at, {{1.2, 2.3, 4.1}});
         }},
        {"spot",
         [](auto at) {
             return "LightSource \"spot\" \"rgb I\" [90 90 90] \"point3 from\" " +
                    list_at(at, {{1.2, 2.3, 5.1}}) + "\"point3 to\" " +
                    list_at(at, {{0.2, 1.1, 0}});
         }},
        {"goniometric, by a Translate",
         [](auto at) {
             return translated(at + Vec3d(1, 2, 4),
                               "LightSource \"goniometric\" \"rgb I\" [9 9 9]");
         }},
        {"emitting sphere",
         [&](auto at) {
             return "AttributeBegin\n" + emits +
                    translated(at + Vec3d(1, 2, 3), "Shape \"sphere\"") + "AttributeEnd\n";
         }},
        {"emitting triangle",
         [&](auto at) {
             return "AttributeBegin\n" + emits + "Shape \"trianglemesh\" \"point3 P\" " +
                    list_at(at, {{-1.2, 1.1, 4.1}, {1.2, 1.1, 4.1}, {0.1, -1.2, 4.2}}) +
                    "AttributeEnd\n";
         }},
        {"portal",
         [&](auto at) {
             return "LightSource \"infinite\" \"rgb L\" [3 3 3] \"point3 portal\" " +
                    list_at(at, opening);
         }},
    };
    for (const Kind& kind : kinds)
        EXPECT_LT(light_elsewhere(kind.make), kMostElsewhere) << kind.name;
}

}  // namespace
}  // namespace sunfleck::engine
