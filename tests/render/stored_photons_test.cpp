// Photons at surfaces that are there in part: stored wherever a visible point may lie, whether the
// surface is there for the photon or not, and scattered as often as it is there.
#include "photon/traced_paths.h"
#include "texture/kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr float kSheet = 1;  // height; a grey floor lies at zero

Cover always(float value) {
    return [value](const Hit&) { return value; };
}

/// Photons straight from the sun, by where they are stored.
struct Stored {
    int sheet = 0;
    int floor = 0;
    int both = 0;  // paths with one at each
};

/// Paths that meet the sheet over the floor.
Stored stored_at(ShapeDescription sheet, std::vector<Material> more = {}, float alpha = 1) {
    if (alpha < 1) sheet.placed.cover = always(alpha);
    SceneDescription scene = sunny({square(0, 0), std::move(sheet)});
    scene.materials.insert(scene.materials.end(), more.begin(), more.end());
    Stored stored;
    for (const Path& path : paths_of(scene, 1)) {
        const auto at = [&](float z) {
            return std::count_if(path.photons.begin(), path.photons.end(), [z](const Photon& p) {
                return p.position.z == z && p.kind == PhotonKind::direct && p.bounces == 0;
            });
        };
        EXPECT_LE(at(kSheet), 1);
        EXPECT_LE(at(0), 1);
        stored.sheet += static_cast<int>(at(kSheet));
        stored.floor += static_cast<int>(at(0));
        stored.both += static_cast<int>(at(kSheet) * at(0));
    }
    return stored;
}

TEST(StoredPhotons, lie_on_surfaces_that_they_pass) {
    const Stored whole = stored_at(square(kSheet, 0));
    EXPECT_GT(whole.sheet, 500);
    EXPECT_EQ(whole.both, 0);
    for (const float alpha : {0.05F, 0.5F, 0.95F}) {
        const Stored part = stored_at(square(kSheet, 0), {}, alpha);
        EXPECT_EQ(part.sheet, whole.sheet) << "as if all of it were there, alpha " << alpha;
        const double passed = part.both / static_cast<double>(part.sheet);
        EXPECT_NEAR(passed, 1 - alpha, 5 * std::sqrt(passed * (1 - passed) / part.sheet)) << alpha;
    }
}

/// A hole in a leaf: discs reach over it from what is there.
TEST(StoredPhotons, lie_in_the_holes_of_surfaces) {
    const Stored hole = stored_at(square(kSheet, 0), {}, 0);
    EXPECT_EQ(hole.sheet, stored_at(square(kSheet, 0)).sheet);
    EXPECT_EQ(hole.both, hole.sheet);
}

TEST(StoredPhotons, never_lie_on_glass) {
    for (const float alpha : {0.5F, 1.0F})
        EXPECT_EQ(stored_at(square(kSheet, 1), {}, alpha).sheet, 0) << alpha;
}

/// Material 4 of a mix: diffuse, or a pane that keeps no photon.
TEST(StoredPhotons, lie_on_a_mix_whichever_component_is_met) {
    const int whole = stored_at(square(kSheet, 0)).sheet;
    for (const float amount : {0.0F, 0.1F, 0.5F, 1.0F}) {
        EXPECT_EQ(stored_at(square(kSheet, 4), {MixMaterial{{0, 1}, amount}}).sheet, whole);
        const std::vector<Material> nested = {MixMaterial{{1, 5}, amount},
                                              MixMaterial{{1, 0}, amount}};
        EXPECT_EQ(stored_at(square(kSheet, 4), nested).sheet, whole);
    }
    EXPECT_EQ(stored_at(square(kSheet, 4), {MixMaterial{{1, 1}, 0.5F}}).sheet, 0);
}

/// Smooth here and rough there: a photon beside a rough place is stored for it.
TEST(StoredPhotons, lie_on_smooth_places_of_what_is_rough_elsewhere) {
    const FloatTexture none_here(FloatKind{BilerpKind<FloatTexture>{UvMapping{}, 0, 0, 0, 0}});
    ConductorMaterial metal{Spectrum::constant(0.2F), Spectrum::constant(4), {}, {}};
    metal.roughness = {none_here, none_here};
    EXPECT_GT(stored_at(square(kSheet, 4), {metal}).sheet, 500);
    metal.roughness = {0.0F, 0.0F};
    EXPECT_EQ(stored_at(square(kSheet, 4), {metal}).sheet, 0);
}

}  // namespace
}  // namespace sunfleck::engine
