// Roughness and its anisotropy.
#include "import/gltf/pbr.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

/// Along the tangent alpha goes to 1 with the square of the strength (KHR_materials_anisotropy).
TEST(GltfPbrTest, anisotropy_widens_along_the_tangent) {
    GltfPbr pbr;
    pbr.roughness = 0.5;
    pbr.anisotropy = 0.6;
    const Roughness roughness = roughness_of(pbr);
    EXPECT_FLOAT_EQ(roughness.u.constant(), 0.25F + 0.75F * 0.36F);
    EXPECT_FLOAT_EQ(roughness.v.constant(), 0.25F);
    EXPECT_FLOAT_EQ(mean_facets(pbr)->alpha_x, roughness.u.constant());
    pbr.anisotropy = 0;
    EXPECT_EQ(roughness_of(pbr).u.constant(), roughness_of(pbr).v.constant());
    pbr.roughness = 0;
    EXPECT_FALSE(mean_facets(pbr)) << "smooth";
}

}  // namespace
}  // namespace sunfleck::engine
