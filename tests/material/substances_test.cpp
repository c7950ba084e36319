// Refractive indices of named materials, against what their sources state.
#include "material/substances.h"

#include "material/named_materials.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr float kD = 587.56F;  // nm: Fraunhofer's lines d, F and C
constexpr float kF = 486.13F;
constexpr float kC = 656.27F;

NamedMaterial named(const std::string& name) {
    return named_material(name, {"x"});
}

Spectrum index_of(const NamedMaterial& glass) {
    return std::get<DielectricMaterial>(glass.material).eta;
}

struct Stated {
    const char* name;
    double index;  // at the d line
    double abbe;
};

TEST(Substances, have_the_indices_and_dispersions_of_their_sources) {
    for (const Stated& stated :
         {Stated{"bk7", 1.5168, 64.2}, Stated{"sf11", 1.7847, 25.7}, Stated{"f2", 1.6200, 36.4},
          Stated{"fused-silica", 1.4585, 67.8}, Stated{"fluorite", 1.4338, 95.0},
          Stated{"sapphire", 1.7682, 72.2}, Stated{"diamond", 2.4175, 55.3},
          Stated{"water", 1.3334, 55.8}, Stated{"lasf9", 1.8503, 32.2}}) {
        const Spectrum n = index_of(named(stated.name));
        EXPECT_NEAR(n(kD), stated.index, 1e-3) << stated.name;
        EXPECT_NEAR((n(kD) - 1) / (n(kF) - n(kC)), stated.abbe, 0.025 * stated.abbe) << stated.name;
    }
}

struct StatedAt {
    const char* name;
    float nm;
    double index;
};

/// Sultanova et al. 2009, table 1; soda-lime glass as refractiveindex.info has it.
TEST(Substances, of_plastic_have_the_indices_that_were_measured) {
    for (const StatedAt& stated :
         {StatedAt{"pmma", 436.8F, 1.502}, StatedAt{"pmma", 587.6F, 1.491},
          StatedAt{"pmma", 703, 1.486}, StatedAt{"polycarbonate", 436.8F, 1.612},
          StatedAt{"polycarbonate", 587.6F, 1.585}, StatedAt{"polycarbonate", 703, 1.575},
          StatedAt{"polystyrene", 436.8F, 1.617}, StatedAt{"polystyrene", 587.6F, 1.592},
          StatedAt{"polystyrene", 703, 1.582}, StatedAt{"soda-lime", 380, 1.53998},
          StatedAt{"soda-lime", 390, 1.53857}})
        EXPECT_NEAR(index_of(named(stated.name))(stated.nm), stated.index, 2e-3)
            << stated.name << " " << stated.nm;
}

/// 4 pi k / wavelength; at 600 nm water has k = 1.09e-8, soda-lime glass 4.548e-7.
TEST(Substances, absorb_as_their_sources_say) {
    EXPECT_NEAR((*named("water").absorption)(600), 0.2283F, 1e-3F);
    EXPECT_NEAR((*named("soda-lime").absorption)(600), 9.525F, 1e-2F);
    EXPECT_FALSE(named("bk7").absorption);
    EXPECT_FALSE(named("gold").absorption);
}

/// Reflectances along the normal: (n - 1)^2 + k^2 over (n + 1)^2 + k^2.
TEST(Substances, of_metal_reflect_as_handbooks_say) {
    const auto reflectance = [](const std::string& name, float nm) {
        const NamedMaterial made = named(name);
        const auto& metal = std::get<ConductorMaterial>(made.material);
        const float n = metal.eta.curve()(nm);
        const float k = metal.k.curve()(nm);
        return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    };
    EXPECT_NEAR(reflectance("gold", 650), 0.96F, 0.02F);
    EXPECT_NEAR(reflectance("gold", 450), 0.38F, 0.03F);
    EXPECT_NEAR(reflectance("silver", 550), 0.97F, 0.02F);
    EXPECT_NEAR(reflectance("aluminium", 550), 0.915F, 0.02F);
    EXPECT_NEAR(reflectance("chromium", 549), 0.55F, 0.02F);
    EXPECT_NEAR(reflectance("iron", 549), 0.53F, 0.03F);
}

}  // namespace
}  // namespace sunfleck::engine
