// A sheet of every material in a sky of radiance one, from both sides: nothing gains, and what has
// no losses shows one. The losses of the others are held here, so that a change is seen.
#include "scene/adjust.h"
#include "support/renders.h"

#include <gtest/gtest.h>

#include <iostream>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

struct Row {
    std::string name;
    std::string material;
    double least = 1;         // of what it shows, on the darker side
    bool solid = false;       // radiance within differs: the sheet has two surfaces
    bool gives_back = false;  // what facets lose
};

void PrintTo(const Row& row, std::ostream* out) {  // NOLINT(readability-identifier-naming)
    *out << row.name;
}

const std::string kWhite = "\"rgb reflectance\" [1 1 1] ";
const std::string kSilver = "\"rgb reflectance\" [.9999 .9999 .9999] ";
const std::string kBumps =
    "Texture \"bumps\" \"float\" \"wrinkled\" \"float roughness\" .3 "
    "Texture \"low\" \"float\" \"scale\" \"texture tex\" \"bumps\" \"float scale\" .2 ";

std::vector<Row> rows() {
    const std::string mix =
        "MakeNamedMaterial \"a\" \"string type\" \"coateddiffuse\" \"float thickness\" 0 " +
        kWhite +
        "MakeNamedMaterial \"b\" \"string type\" \"thindielectric\" "
        "Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .4 ";
    return {
        {"diffuse", "Material \"diffuse\" " + kWhite},
        {"glass", "Material \"dielectric\" ", 1, true},
        {"rough_glass", "Material \"dielectric\" \"float roughness\" .1 ", 0.7, true},
        {"pane", "Material \"thindielectric\" "},
        {"silver", "Material \"conductor\" " + kSilver, 0.999},
        {"rough_silver", "Material \"conductor\" \"float roughness\" .1 " + kSilver, 0.82},
        {"kept_glass", "Material \"dielectric\" \"float roughness\" .1 ", 0.995, true, true},
        {"frosted_glass", "Material \"dielectric\" \"float roughness\" .5 ", 0.995, true, true},
        {"kept_silver", "Material \"conductor\" \"float roughness\" .3 " + kSilver, 0.997, false,
         true},
        {"kept_patchy_silver",
         "Texture \"patchy\" \"float\" \"wrinkled\" "
         "Material \"conductor\" \"texture roughness\" \"patchy\" " +
             kSilver,
         0.997, false, true},
        {"leaf",
         "Material \"diffusetransmission\" \"rgb reflectance\" [.3 .3 .3] "
         "\"rgb transmittance\" [.7 .7 .7] "},
        {"varnish", "Material \"coateddiffuse\" \"float thickness\" 0 " + kWhite},
        {"satin",
         "Material \"coateddiffuse\" \"float thickness\" 0 \"float roughness\" .1 " + kWhite, 0.65},
        {"lacquer",
         "Material \"coatedconductor\" \"float interface.thickness\" 0 "
         "\"float conductor.roughness\" 0 " +
             kSilver,
         0.995},
        {"satin_lacquer",
         "Material \"coatedconductor\" \"float interface.thickness\" 0 "
         "\"float interface.roughness\" .1 " +
             kSilver,
         0.84},
        {"mix", mix},
        {"clear_hair", "Material \"hair\" \"rgb sigma_a\" [0 0 0] "},
        {"brown_hair", "Material \"hair\" ", 0.25},
        {"milk", "Material \"subsurface\" " + kWhite},
        {"rough_milk", "Material \"subsurface\" \"float roughness\" .1 " + kWhite, 0.9},
        {"skin", "Material \"subsurface\" \"string name\" \"Skin1\" ", 0.2},
        {"bumpy_diffuse",
         kBumps + "Material \"diffuse\" \"texture displacement\" \"low\" " + kWhite, 0.9},
        {"bumpy_varnish",
         kBumps +
             "Material \"coateddiffuse\" \"float thickness\" 0 "
             "\"texture displacement\" \"low\" " +
             kWhite,
         0.9},
        {"bumpy_milk",
         kBumps + "Material \"subsurface\" \"texture displacement\" \"low\" " + kWhite, 0.9},
    };
}

class Furnace : public ::testing::TestWithParam<Row> {};

/// What the sheet shows, seen aslant from height z.
Estimate shown(const Row& row, int z, Integrator integrator) {
    SceneDescription description = read_pbrt_text(
        view("0 -1 " + std::to_string(z) + "  0 0 0  0 1 0", 20, 4) +
            "LightSource \"infinite\" \"spectrum L\" \"stdillum-D65\"\n" + row.material +
            (row.solid ? box({-2, -2, -.1}, {2, 2, 0.1}) : quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0")),
        "test.pbrt");
    if (row.gives_back) compensate_energy(description);
    const Scene scene(std::move(description));
    RenderSettings settings;
    settings.integrator = integrator;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 64;
    return Estimate::over(12, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, row.gives_back ? 128 : 16).mean());
    });
}

TEST_P(Furnace, gains_nothing_on_either_side) {
    for (const int z : {1, -1})
        for (const Integrator integrator : {Integrator::sppm, Integrator::path, Integrator::bdpt}) {
            const Estimate value = shown(GetParam(), z, integrator);
            const double noise = 4 * value.error + 1e-4;
            EXPECT_LT(value.error, 0.01);
            EXPECT_LE(value.mean, 1 + noise + (GetParam().gives_back ? 0.003 : 0)) << z;
            EXPECT_GE(value.mean, GetParam().least - noise) << z;
            std::cout << (z > 0 ? "above " : "below ") << value.mean << " +- " << value.error
                      << '\n';
        }
}

INSTANTIATE_TEST_SUITE_P(Of, Furnace, ::testing::ValuesIn(rows()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace sunfleck::engine
