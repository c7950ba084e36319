// Words of MTL as materials: what programs write, and what it is taken for.
#include "import/part/mtl_looks.h"

#include "part_files.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

class MtlLook : public testing_support::PartFolder {
protected:
    struct Seen {
        SceneDescription scene;
        Material material;
    };
    Seen seen(const std::string& mtl) const {
        SceneDescription scene = with_material(mtl);
        const Material material = scene.materials[scene.shapes[0].material];
        return {std::move(scene), material};
    }
    std::string kind(const std::string& mtl) const {
        return std::string(name_of(seen(mtl).material));
    }

    static float alpha_of(const Material& material) {
        if (const auto* metal = std::get_if<ConductorMaterial>(&material))
            return metal->roughness.u.constant();
        if (const auto* glass = std::get_if<DielectricMaterial>(&material))
            return glass->roughness.u.constant();
        const auto& facets = std::get<CoatedDiffuseMaterial>(material).coat->facets();
        return facets ? facets->alpha_x : 0;
    }
};

struct Kind {
    const char* mtl;
    const char* kind;
};

/// What writes it stands behind it.
TEST_F(MtlLook, is_the_material_that_is_meant) {
    for (const Kind& row : {
             Kind{"", "diffuse"},
             Kind{"Kd 1 0 0\nillum 1\nKs 1 1 1\n", "diffuse"},
             Kind{"Kd .5 .5 .5\nKs .5 .5 .5\nNs 250\nNi 1.45\nillum 2\nd 1\n",
                  "coateddiffuse"},                                                   // Blender
             Kind{"illum 4\nKd .5 .5 .5\nKa 0 0 0\nTf 1 1 1\nNi 1.00\n", "diffuse"},  // Maya
             Kind{"Ns 10\nNi 1.5\nd 1\nTr 0\nTf 1 1 1\nillum 2\nKd .6 .6 .6\nKs 0 0 0\n",
                  "diffuse"},  // 3ds Max
             Kind{"Ns 200\nNi 1.5\nd 1\nTr 0\nTf 1 1 1\nillum 7\nKd 0 0 0\nKs .01 .01 .01\n",
                  "dielectric"},  // McGuire's Cornell boxes
             Kind{"illum 4\nd 0.1\n", "dielectric"},
             Kind{"illum 9\nNi 1.33\nd 1\n", "dielectric"},
             Kind{"illum 4\nd 0.1\nNi 1\n", "diffuse"},
             Kind{"Kd 0 0 0\nKs .9 .7 .3\nNs 500\nillum 3\n", "conductor"},
             Kind{"Kd .9 .7 .3\nPm 1\nPr .2\n", "conductor"},
             Kind{"Kd .9 .7 .3\nPm 0\nPr .2\n", "coateddiffuse"},
             Kind{"Kd .9 .7 .3\nPm .5\nPr .2\n", "mix"},
             Kind{"Kd .9 .7 .3\nPm 1\nPr .2\nPc 1\n", "coatedconductor"},
         })
        EXPECT_EQ(kind(row.mtl), row.kind) << row.mtl;
}

TEST_F(MtlLook, has_the_index_of_its_file) {
    EXPECT_EQ(std::get<DielectricMaterial>(seen("illum 7\nNi 1.33\n").material).eta(550), 1.33F);
    EXPECT_EQ(std::get<DielectricMaterial>(seen("illum 7\nd .2\n").material).eta(550), 1.5F);
}

/// Phong's exponent gives sqrt(2 / (Ns + 2)); Blender's Ns is 1000 (1 - roughness)^2.
TEST_F(MtlLook, has_the_roughness_of_its_words) {
    EXPECT_FLOAT_EQ(alpha_of(seen("Ks 1 1 1\nNs 198\n").material), 0.1F);
    EXPECT_FLOAT_EQ(alpha_of(seen("Pr .2\nPm 1\nNs 198\n").material), 0.04F);
    EXPECT_FLOAT_EQ(alpha_of(seen("illum 7\nNi 1.5\nNs 2\n").material), 0);
    written("a.mtl", "# Blender 3.4 MTL File\nnewmtl m\nKs .5 .5 .5\nNs 250\nillum 2\n");
    const SceneDescription scene = read("mtllib a.mtl\nusemtl m\n" + testing_support::kTetrahedron);
    EXPECT_NEAR(alpha_of(scene.materials[scene.shapes[0].material]), 0.25F, 1e-6F);
}

/// Of d and Tr d counts; one that leaves nothing of the surface is a writer's error (MeshLab and
/// OpenMVS wrote Tr 1 for what is opaque).
TEST_F(MtlLook, covers_in_part_by_d_or_tr) {
    const auto alpha = [&](const std::string& mtl) {
        const SceneDescription scene = with_material(mtl);
        return scene.shapes[0].alpha ? scene.shapes[0].alpha->constant() : 1;
    };
    EXPECT_FLOAT_EQ(alpha("d 0.25\n"), 0.25F);
    EXPECT_FLOAT_EQ(alpha("Tr 0.25\n"), 0.75F);
    EXPECT_FLOAT_EQ(alpha("d 0.25\nTr 0.25\n"), 0.25F);
    EXPECT_EQ(alpha("Tr 1\n"), 1);
    EXPECT_EQ(alpha("d 0\n"), 1);
    EXPECT_NE(warnings_of(with_material("Tr 1\n")).find("would be invisible"), std::string::npos);
}

TEST_F(MtlLook, has_pictures) {
    written("red.pfm", testing_support::pfm({1, 0, 0, 0.5F, 0, 0}));
    written("half.pfm", testing_support::pfm({0.5F, 0.5F, 0.5F}));
    written("up.pfm", testing_support::pfm({0.5F, 0.5F, 1}));
    const Seen made = seen(
        "Kd 0 0 0\nmap_Kd red.pfm\nmap_d half.pfm\nmap_Bump -bm 2 up.pfm\n"
        "map_Ke half.pfm\nmap_Ks red.pfm\n");
    EXPECT_FALSE(std::get<DiffuseMaterial>(made.material).reflectance.is_constant());
    ASSERT_TRUE(made.scene.shapes[0].alpha);
    EXPECT_FLOAT_EQ(made.scene.shapes[0].alpha->at({}), 0.5F);
    ASSERT_TRUE(made.scene.shapes[0].emission);
    EXPECT_NE(made.scene.shapes[0].emission->image, nullptr);
    const auto& normals = std::get<NormalMap>(made.scene.bump_maps[made.scene.shapes[0].material]);
    EXPECT_EQ(normals.strength, 2);
    EXPECT_NE(warnings_of(made.scene).find("\"map_ks\" is left out"), std::string::npos);
    EXPECT_NE(warnings_of(with_material("bump half.pfm\n")).find("map of heights is left out"),
              std::string::npos);
}

/// The square of a map of roughness is the alpha.
TEST_F(MtlLook, of_metal_has_a_map_of_roughness) {
    written("half.pfm", testing_support::pfm({0.5F, 0.5F, 0.5F}));
    const Seen made = seen("Pm 1\nmap_Pr half.pfm\n");
    const auto& metal = std::get<ConductorMaterial>(made.material);
    EXPECT_FLOAT_EQ(metal.roughness.u.at({}), 0.25F);
}

}  // namespace
}  // namespace sunfleck::engine
