// Sunlight that falls through a small hole into fog: a beam that light samples hardly ever meet.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kAbsorption = 0.02;
constexpr double kScattering = 0.1;
constexpr double kG = 0.3;
constexpr double kWide = 4;  // the box, around the origin; its walls are black
constexpr double kAway = 1.8;

/// The sun shines down through a square hole in the middle of the roof.
std::string box_of_fog(double hole) {
    const auto square = [](double x0, double y0, double x1, double y1, double z) {
        std::ostringstream text;
        for (const auto& [x, y] :
             {std::pair(x0, y0), std::pair(x0, y1), std::pair(x1, y1), std::pair(x1, y0)})
            text << x << ' ' << y << ' ' << z << "  ";
        return quad(text.str());
    };
    const double h = hole / 2;
    const double w = kWide / 2;
    return "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"spectrum sigma_a\" [200 .02 "
           "900 .02] \"spectrum sigma_s\" [200 .1 900 .1] \"float g\" 0.3\n"
           "MediumInterface \"\" \"fog\"\n" +
           view("0 -1.8 0  0 0 0  0 0 1", 60, 16) +
           "MediumInterface \"\" \"\"\nLightSource \"distant\" \"point3 from\" [0 0 1] \"point3 "
           "to\" [0 0 0] "
           "\"spectrum L\" \"stdillum-D65\"\n" +
           diffuse("0 0 0") + square(-w, -w, w, w, -w) + square(-w, -w, w, -h, w) +
           square(-w, h, w, w, w) + square(-w, -h, -h, h, w) + square(h, -h, w, h, w) +
           quad("-2 -2 -2  -2 2 -2  -2 2 2  -2 -2 2") + quad("2 -2 -2  2 -2 2  2 2 2  2 2 -2") +
           quad("-2 -2 -2  -2 -2 2  2 -2 2  2 -2 -2") + quad("-2 2 -2  2 2 -2  2 2 2  -2 2 2") +
           "Material \"interface\"\nMediumInterface \"\" \"fog\"\n" + square(-h, -h, h, h, w);
}

/// Mean brightness of the picture for a hole of one square unit, scattered once.
double beam_over_picture() {
    const double tangent = 1 / std::sqrt(3.0);  // of half the field of view
    const double highest = kAway * tangent;
    constexpr int kSteps = 10'000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = ((i + 0.5) / kSteps * 2 - 1) * highest;
        const double d = std::sqrt(kAway * kAway + z * z);
        const double bent = 1 + kG * kG - 2 * kG * z / d;
        const double phase = (1 - kG * kG) / (4 * kPiDouble * bent * std::sqrt(bent));
        const double through = std::exp(-(kAbsorption + kScattering) * (kWide / 2 - z + d));
        const double slant = d / kAway;  // a steradian at the picture's edge is more of its area
        sum += kScattering * phase * through / (d * d) * slant * slant * slant;
    }
    return sum * 2 * highest / kSteps / (4 * tangent * tangent);
}

/// One photon in two hundred thousand comes through; by light samples alone nothing is ever found.
TEST(GapInFog, is_found_by_photons) {
    constexpr double kHole = 0.01;
    const Scene scene = scene_of(box_of_fog(kHole));
    const Estimate beam = Estimate::over(8, [&](int i) {
        RenderSettings settings;
        settings.seed = static_cast<std::uint64_t>(i);
        settings.transport.max_depth = 1;
        settings.photon.paths_per_pass = 20'000;
        return luminance(render_mean(scene, settings, 16).mean());
    });
    const double expected = beam_over_picture() * kHole * kHole;
    EXPECT_LT(std::abs(beam.mean - expected), 3 * beam.error)
        << beam.mean / expected << " +- " << beam.error / expected;
    EXPECT_LT(beam.error, 0.04 * expected);
}

}  // namespace
}  // namespace sunfleck::engine
