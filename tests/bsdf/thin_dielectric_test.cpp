// A pane equals the plate of two faces that it stands for, and bends nothing.
#include "bsdf/thin_dielectric.h"

#include "laws/bsdf_examples.h"
#include "laws/bsdf_fresnel.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Echo by echo: what returns and what passes, until nothing is left.
TEST(ThinDielectric, reflectance_is_the_sum_of_all_echoes) {
    const auto echoes = [](double face) {
        double returned = face;
        double between = 1 - face;
        for (int echo = 0; echo < 400; ++echo) {
            between *= face;  // reflected at the far face
            returned += between * (1 - face);
            between *= face;  // and at the near one
        }
        return returned;
    };
    const ThinDielectric pane{laws::ramp(1.3F, 1.9F)};
    for (const float cosine : {1.0F, 0.5F, 0.1F})
        for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
            EXPECT_NEAR(pane.reflectance(cosine)[wavelength],
                        echoes(laws::fresnel(cosine, pane.eta[wavelength])), 1e-5);
}

TEST(ThinDielectric, passes_straight_on_and_mirrors) {
    const ThinDielectric pane{SampledSpectrum(1.5F)};
    for (const Vec3& w : laws::probe_directions())
        for (const Transport t : {Transport::radiance, Transport::flux}) {
            const auto passed = pane.sample(w, {Vec3(1 - 0x1p-24F, 0, 0), t, {}});
            EXPECT_EQ(passed->wi, -w);
            EXPECT_EQ(passed->eta, 1);
            EXPECT_EQ(passed->weight, SampledSpectrum(1));
            const auto mirrored = pane.sample(w, {Vec3(0x1p-24F, 0, 0), t, {}});
            EXPECT_EQ(mirrored->wi, Vec3(-w.x, -w.y, w.z));
        }
}

TEST(ThinDielectric, keeps_all_wavelengths) {
    const ThinDielectric pane{laws::ramp(1.3F, 1.9F)};
    const auto passed =
        pane.sample(laws::direction_at(0.5F, 0), {Vec3(0.9F, 0, 0), Transport::flux, {3, false}});
    EXPECT_FALSE(passed->dispersed);
    EXPECT_GT(passed->weight.min(), 0.5F);
}

}  // namespace
}  // namespace sunfleck::engine
