// Whole glTF files: extensions, and all public samples that are here.
#include "import/gltf/reader.h"

#include "geometry/measure.h"
#include "gltf_files.h"
#include "import/gltf/draco.h"
#include "sample_files.h"

#include <map>
#include <set>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

using testing_support::GltfSample;
using testing_support::Probed;
using testing_support::square_json;
using testing_support::warns;

class GltfReader : public testing_support::GltfFiles {};

TEST_F(GltfReader, required_extensions_that_are_not_read_are_refused) {
    EXPECT_EQ(fault_of(R"("extensionsRequired":["KHR_texture_basisu"])"),
              "scene.gltf: extensionsRequired[0]: requires the extension "
              "KHR_texture_basisu, which is not read; export the scene without it");
    const std::string packed = fault_of(R"("extensionsRequired":["KHR_draco_mesh_compression"])");
    EXPECT_EQ(packed.find("built without Draco") != std::string::npos, !has_draco()) << packed;
    EXPECT_EQ(fault_of(R"("extensionsRequired":["KHR_mesh_quantization"])"), "");
}

TEST_F(GltfReader, used_extensions_that_are_not_read_are_named) {
    const SceneDescription scene =
        read(R"("extensionsUsed":["EXT_not_known","KHR_materials_ior","KHR_xmp"])");
    EXPECT_TRUE(warns(scene, "the extension EXT_not_known is not read"));
    EXPECT_FALSE(warns(scene, "KHR_xmp") || warns(scene, "KHR_materials_ior"));
}

/// A mirrored node keeps its outside out.
TEST_F(GltfReader, mirrored_nodes_keep_their_facing) {
    for (const char* scale : {"[1,1,1]", "[-1,1,1]", "[1,-1,1]"}) {
        const Scene scene(read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":)" +
                               std::string(scale) + "}]," + square_json()));
        const Vec3d from(scale[1] == '-' ? -0.4 : 0.4, scale[3] == '-' ? -0.3 : 0.3, 5);
        const auto hit =
            scene.geometry().intersect(Ray{Vec3(from - scene.origin()), Vec3(0, 0, -1), 100.0F});
        ASSERT_TRUE(hit) << scale;
        EXPECT_GT(hit->normal.z, 0.9F) << scale;
    }
}

/// All forms of one file: text, binary, packed.
TEST_F(GltfSample, boxes_of_all_containers_are_the_same) {
    const SceneDescription first = sample("Box-glb/Box.glb");
    const auto& mesh = std::get<TriangleMesh>(first.shapes.at(0).placed.shape);
    std::vector<std::string> others = {"Box-embedded/Box.gltf"};
    if (has_draco()) others.emplace_back("Box-draco/Box.gltf");
    EXPECT_EQ(bounds_of(first.shapes[0].placed).min, Vec3d(-0.5));
    for (const std::string& name : others) {
        const SceneDescription other = sample(name);
        EXPECT_EQ(bounds_of(other.shapes.at(0).placed).min, Vec3d(-0.5)) << name;
        EXPECT_EQ(bounds_of(other.shapes[0].placed).max, Vec3d(0.5)) << name;
        const auto& packed = std::get<TriangleMesh>(other.shapes[0].placed.shape);
        EXPECT_EQ(packed.triangles.size(), mesh.triangles.size()) << name;
        EXPECT_EQ(packed.normals.size(), mesh.normals.size()) << name;
    }
}

/// Each corner's colour is its place: that of a face's middle is the middle's place.
TEST_F(GltfSample, box_vertex_colors_has_its_colours) {
    const Probed box(sample("BoxVertexColors/BoxVertexColors.gltf"));
    const Wavelengths wavelengths = probe_wavelengths();
    for (const Vec3d& from : {Vec3d(2, 0.3, 0.6), Vec3d(0.3, 2, 0.6), Vec3d(0.3, 0.6, 2)}) {
        const Vec3d side(from.x > 1 ? 1 : 0, from.y > 1 ? 1 : 0, from.z > 1 ? 1 : 0);
        const auto hit = box.hit(from, -side);
        ASSERT_TRUE(hit);
        const SampledSpectrum wanted = Spectrum::rgb_albedo(Vec3(from - side)).at(wavelengths);
        const SampledSpectrum found = box.colour(*hit, wavelengths);
        for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-3F);
    }
}

TEST_F(GltfSample, cameras_has_one_of_each_kind) {
    ImportSettings settings;
    EXPECT_TRUE(std::holds_alternative<PerspectiveCamera>(sample("Cameras/Cameras.gltf").camera));
    settings.camera = "2";
    EXPECT_TRUE(std::holds_alternative<OrthographicCamera>(
        sample("Cameras/Cameras.gltf", settings).camera));
}

TEST_F(GltfSample, simple_sparse_accessor_moves_three_vertices) {
    const SceneDescription scene = sample("SimpleSparseAccessor/SimpleSparseAccessor.gltf");
    const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).placed.shape);
    EXPECT_EQ(mesh.positions.at(8), Vec3(1, 2, 0));
    EXPECT_EQ(mesh.positions.at(10), Vec3(3, 3, 0));
    EXPECT_EQ(mesh.positions.at(12), Vec3(5, 4, 0));
}

TEST_F(GltfSample, simple_instancing_places_one_box_125_times) {
    const SceneDescription scene = sample("SimpleInstancing/SimpleInstancing.gltf");
    EXPECT_EQ(scene.objects.size(), 1U);
    EXPECT_EQ(scene.instances.size(), 125U);
}

/// Balls show their outside, whatever mirrors their nodes. Above them are marks that a viewer which
/// culls does not see; we see surfaces from both sides.
TEST_F(GltfSample, negative_scales_keep_their_facing) {
    const Probed scene(sample("NegativeScaleTest/NegativeScaleTest.glb"));
    int seen = 0;
    int turned = 0;
    for (int x = -40; x <= 40; ++x)
        for (int y = -50; y <= 5; ++y) {
            const auto hit = scene.hit({x * 0.08 + 0.003, y * 0.08 + 0.002, 20}, {0, 0, -1});
            if (!hit) continue;
            ++seen;
            if (hit->normal.z < 0) ++turned;
        }
    EXPECT_GT(seen, 1000);
    EXPECT_EQ(turned, 0);
}

/// Strengths of 1, 2, 4, 8 and 16 from left to right.
TEST_F(GltfSample, emissive_strength_doubles_from_cube_to_cube) {
    const SceneDescription scene = sample("EmissiveStrengthTest/EmissiveStrengthTest.glb");
    std::map<double, double> by_place;
    for (const ShapeDescription& shape : scene.shapes)
        if (shape.emission)
            by_place[shape.placed.to_world[3][0]] = shape.emission->radiance.luminance();
    ASSERT_EQ(by_place.size(), 5U);
    double wanted = by_place.begin()->second;
    EXPECT_NEAR(wanted, 0.2126 * 0.1 + 0.7152 * 0.5 + 0.0722 * 0.9, 1e-3) << "by Blender: watts";
    for (const auto& [place, luminance] : by_place) {
        EXPECT_NEAR(luminance, wanted, 1e-3 * wanted) << place;
        wanted *= 2;
    }
}

/// Blocks of a column look alike: by base colour, by thickness, by scale and by distance.
TEST_F(GltfSample, attenuation_follows_beers_law) {
    const Probed scene(sample("AttenuationTest/AttenuationTest.gltf"));
    const Wavelengths wavelengths = probe_wavelengths();
    const Vec3d ahead(0, 0, -1);
    for (const auto& [x, thickness] :
         std::map<double, double>{{0, 1}, {2.5, 1.5}, {6, 2}, {-2, 0.5}, {-3.5, 0.25}}) {
        const auto power = [&](double colour) { return std::pow(colour, thickness); };
        const SampledSpectrum thin =
            Spectrum::rgb_albedo(Vec3(Vec3d(power(0.1), power(0.5), power(0.9)))).at(wavelengths);
        SampledSpectrum wanted =
            Spectrum::rgb_unbounded(Vec3(Vec3d(-std::log(0.1), -std::log(0.5), -std::log(0.9))))
                .at(wavelengths);
        for (float& v : wanted.values) v = std::exp(-v * static_cast<float>(thickness));
        for (const double y : {3.0, -3.0, -6.0}) {
            const auto hit = scene.hit({x + 0.01, y + 0.02, 5}, ahead);
            ASSERT_TRUE(hit) << x << ' ' << y;
            const SampledSpectrum left = scene.left_behind(*hit, ahead, wavelengths);
            for (std::size_t i = 0; i < kWavelengths; ++i)
                EXPECT_NEAR(left[i], wanted[i], 2e-3F) << x << ' ' << y;
        }
        const auto pane = scene.hit({x + 0.01, 6.02, 5}, ahead);
        ASSERT_TRUE(pane);
        const auto& glass = std::get<ThinDielectricMaterial>(scene.material(*pane));
        const SampledSpectrum passed = glass.colour.curve().at(wavelengths);
        for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_NEAR(passed[i], thin[i], 1e-3F) << x;
    }
}

TEST_F(GltfSample, animated_morph_cube_grows_and_shrinks) {
    ImportSettings settings;
    const auto height = [&](double seconds) {
        settings.frame_time = seconds;
        const SceneDescription scene =
            sample("AnimatedMorphCube-quantized/AnimatedMorphCube.gltf", settings);
        const Bounds bounds = bounds_of(scene.shapes.at(0).placed);
        return bounds.max - bounds.min;
    };
    const Vec3d rest = height(0);
    EXPECT_NEAR(rest.x, 2, 1e-3);
    const Vec3d later = height(1.5);  // its half has moved towards the other
    EXPECT_NEAR(rest.x + rest.y + rest.z - (later.x + later.y + later.z),
                5188 * 3.649e-4 * 252 / 255, 0.01);
    EXPECT_EQ(height(99), rest) << "stands after its end";
}

TEST_F(GltfSample, avocado_is_quantized_and_six_centimetres_high) {
    const SceneDescription scene = sample("Avocado-quantized/Avocado.gltf");
    const Bounds bounds = bounds_of(scene.shapes.at(0).placed);
    EXPECT_NEAR(bounds.max.y - bounds.min.y, 0.0628, 2e-4);
    EXPECT_FALSE(is_flat(scene.bump_maps.at(scene.shapes[0].material)));
}

/// Roughness grows from left to right, metal from below to above.
/// Offsets choose the quarters of the picture that are marked as right: green, blue, both.
TEST_F(GltfSample, texture_transforms_choose_the_right_quarters) {
    const Probed scene(sample("TextureTransformTest/TextureTransformTest.gltf"));
    const Wavelengths wavelengths = probe_wavelengths();
    const auto colour = [&](double x) {
        const auto hit = scene.hit({x - 0.35, 0.9, 5}, {0, 0, -1});
        const SampledSpectrum found = hit ? scene.colour(*hit, wavelengths) : SampledSpectrum(-1);
        return Vec3(found[6], found[3], found[0]);  // at 640, 535 and 430 nm
    };
    const Vec3 of_u = colour(-1.1);
    EXPECT_TRUE(of_u.y > 2 * of_u.x && of_u.y > 2 * of_u.z) << of_u;
    const Vec3 of_v = colour(0);
    EXPECT_TRUE(of_v.z > 2 * of_v.x && of_v.z > 2 * of_v.y) << of_v;
    const Vec3 of_both = colour(1.1);
    EXPECT_TRUE(of_both.y > 2 * of_both.x && of_both.z > 2 * of_both.x) << of_both;
}

TEST_F(GltfSample, metal_rough_spheres_are_all_there) {
    const SceneDescription scene =
        sample("MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb");
    std::set<float> alphas;
    for (const Material& material : scene.materials)
        if (const auto* metal = std::get_if<ConductorMaterial>(&material))
            alphas.insert(metal->roughness.u.constant());
    EXPECT_EQ(alphas.size(), 7U);
    EXPECT_GE(scene.materials.size(), 98U);
}

TEST_F(GltfSample, glass_is_glass) {
    const auto count = [&]<class M>(const char* name, const M&) {
        const SceneDescription scene = sample(name);
        std::size_t shapes = 0;
        for (const ShapeDescription& shape : scene.shapes)
            if (std::holds_alternative<M>(scene.materials[shape.material])) ++shapes;
        return shapes;
    };
    EXPECT_EQ(
        count("TransmissionRoughnessTest/TransmissionRoughnessTest.gltf", DielectricMaterial()), 5U)
        << "one row an index";
    EXPECT_EQ(count("IridescenceSuzanne/IridescenceSuzanne.gltf", IridescentConductorMaterial()),
              1U);
}

/// Alpha cuts holes into the pane, in its middle and nowhere near its edges.
TEST_F(GltfSample, broken_window_has_holes) {
    const SceneDescription description = sample("GlassBrokenWindow/GlassBrokenWindow.gltf");
    const Bounds bounds = bounds_of(description.shapes.at(1).placed);
    const Vec3d size = bounds.max - bounds.min;
    const Probed scene(description);
    const auto is_hole = [&](double x, double y) {
        const Vec3d from = bounds.center() + Vec3d(x * size.x, y * size.y, 9);
        return !scene.hit(from, {0, 0, -1});
    };
    int holes = 0;
    for (int x = -10; x <= 10; ++x)
        for (int y = -10; y <= 10; ++y) holes += is_hole(x * 0.02, y * 0.02) ? 1 : 0;
    EXPECT_GT(holes, 10);
    for (const double side : {-0.4, 0.4}) {
        EXPECT_FALSE(is_hole(side, 0.1));
        EXPECT_FALSE(is_hole(0.1, side));
    }
}

/// Follows a ray of one wavelength by Snell's law. @return  where it meets a surface of no glass.
Vec3d refracted(const Probed& scene, Vec3d from, Vec3d along, float nm) {
    for (int surface = 0; surface < 8; ++surface) {
        const auto hit = scene.hit(from, along);
        if (!hit) break;
        const Vec3d place = Vec3d(hit->position) + scene.scene().origin();
        const auto* glass = std::get_if<DielectricMaterial>(&scene.material(*hit));
        if (glass == nullptr) return place;
        Vec3d normal(hit->normal);
        const bool enters = normal.dot(along) < 0;
        if (!enters) normal = -normal;
        const double ratio = enters ? 1 / glass->eta(nm) : double{glass->eta(nm)};
        const double cosine = -normal.dot(along);
        const double inside = std::sqrt(1 - ratio * ratio * (1 - cosine * cosine));
        along = along * ratio + normal * (ratio * cosine - inside);
        from = place + along * 1e-6;
    }
    return Vec3d(kInfinity);
}

/// Each of Fraunhofer's lines meets the floor where ../shared/data/README.md works it out.
TEST_F(GltfSample, prism_disperses) {
    const SceneDescription description = sample("PrismDispersion/PrismDispersion.gltf");
    const Vec3d along = std::get<DistantLight>(description.lights.at(0)).direction;
    const Probed scene(description);
    const Vec3d slit(-0.12, 0.18424, 0);
    EXPECT_NEAR(refracted(scene, slit, along, 486.13F).x, 0.0420, 1e-4);
    EXPECT_NEAR(refracted(scene, slit, along, 587.56F).x, 0.0497, 1e-4);
    EXPECT_NEAR(refracted(scene, slit, along, 656.27F).x, 0.0529, 1e-4);
}

/// All are read, and have something to be seen; that which requires Draco where it is built in.
TEST_F(GltfSample, all_are_read) {
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
        const std::string file = entry.path().string();
        if (!file.ends_with(".gltf") && !file.ends_with(".glb")) continue;
        if (file.find("draco") != std::string::npos && !has_draco()) continue;
        const SceneDescription scene = read_gltf(file);
        EXPECT_GT(scene.shapes.size() + scene.instances.size(), 0U) << file;
    }
}

}  // namespace
}  // namespace sunfleck::engine
