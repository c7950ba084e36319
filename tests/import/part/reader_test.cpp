// Parts as scenes, and the same part in all formats.
#include "import/part/reader.h"

#include "geometry/geometry.h"
#include "geometry/measure.h"
#include "import/gltf/reader.h"
#include "part_files.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

using testing_support::kOpenTetrahedron;
using testing_support::kTetrahedron;
using testing_support::mesh_of;

class Part : public testing_support::PartFolder {
protected:
    static ImportSettings of_material(const std::string& name) {
        ImportSettings settings;
        settings.material = name;
        return settings;
    }
};

const std::string kAsciiStl =
    "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 20 0 0\nvertex 0 10 -30\n"
    "endloop\nendfacet\nendsolid t\n";

TEST_F(Part, of_stl_stands_in_millimetres_with_z_up) {
    const SceneDescription scene = read_part(written("a.STL", kAsciiStl), {});
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(bounds_of(scene.shapes[0].placed).max.x, 20 * 0.001);
    // The ground lies below by 10^-4 of half the diagonal.
    const double lowest = bounds_of(scene.shapes[1].placed).max.z;
    EXPECT_LT(lowest, -0.03);
    EXPECT_GT(lowest, -0.03 - 1e-5);
    EXPECT_EQ(bounds_of(scene.shapes[1].placed).min.z, lowest);
    EXPECT_EQ(scene.film.resolution, Vec2i(1280, 720));
    EXPECT_EQ(warnings_of(scene),
              "a.STL: warning: there is no material: light grey plastic is used (--material)\n"
              "a.STL: warning: its axes and unit are taken as z up and mm: it is 20 x 10 x 30 mm "
              "(--up, --unit)\n");
}

TEST_F(Part, takes_axes_unit_and_ground_from_the_settings) {
    ImportSettings settings = of_material("gold");
    settings.up = UpAxis::y;
    settings.metres_per_unit = 0.0254;
    settings.ground = false;
    const SceneDescription scene = read_part(written("a.stl", kAsciiStl), settings);
    ASSERT_EQ(scene.shapes.size(), 1U);
    EXPECT_DOUBLE_EQ(bounds_of(scene.shapes[0].placed).max.x, 20 * 0.0254);
    EXPECT_EQ(warnings_of(scene), "");
    const auto& camera = std::get<PerspectiveCamera>(scene.camera);
    EXPECT_GT(camera.camera_to_world[1][1], 0.5) << "y is up in the picture";
    EXPECT_EQ(up_of_part("a.stl", {}), UpAxis::z);
    EXPECT_EQ(up_of_part("a.obj", {}), UpAxis::y);
    EXPECT_EQ(up_of_part("a.ply", {}), UpAxis::y);
}

TEST_F(Part, is_told_by_its_ending) {
    for (const char* name : {"a.stl", "A.OBJ", "x.y/b.Ply"}) EXPECT_TRUE(is_part(name)) << name;
    for (const char* name : {"a.pbrt", "obj", "a.glb", "stl/a"})
        EXPECT_FALSE(is_part(name)) << name;
}

TEST_F(Part, has_a_named_material_where_its_file_says_none) {
    const auto material_of = [&](const std::string& mesh, const std::string& name) {
        const SceneDescription scene = read(mesh, of_material(name));
        return std::string(name_of(scene.materials[scene.shapes[0].material]));
    };
    EXPECT_EQ(material_of(kTetrahedron, ""), "coateddiffuse");
    EXPECT_EQ(material_of(kTetrahedron, "gold:0.2"), "conductor");
    EXPECT_EQ(material_of(kTetrahedron, "glass:bk7"), "dielectric");
    EXPECT_EQ(material_of(kOpenTetrahedron, "glass:bk7"), "thindielectric");
    EXPECT_EQ(fault_of(kTetrahedron, of_material("bk9")).substr(0, 38),
              "--material: there is no material \"bk9\"");
    const SceneDescription water = read(kTetrahedron, of_material("water"));
    ASSERT_EQ(water.media.all.size(), 2U);
    EXPECT_EQ(water.shapes[0].media.inside, 1U);
    EXPECT_GT(water.media.all[1].absorption(700), 0);
}

TEST_F(Part, names_its_files_and_remarks) {
    written("a.mtl", "newmtl m\nKd 1 0 0\nhalo\n");
    const SceneDescription scene =
        read("mtllib a.mtl\nusemtl n\nl 1 2\n" + kTetrahedron + "usemtl m\nf 1 2 3\n");
    EXPECT_EQ(scene.files, (std::vector<std::string>{path("a.obj"), path("a.mtl")}));
    EXPECT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(warnings_of(scene),
              "a.obj: warning: lines are left out (1)\n"
              "a.mtl:3:1: warning: \"halo\" is no statement of MTL, and is left out\n"
              "a.obj:2:7: warning: there is no material \"n\" in the part's libraries\n"
              "a.obj: warning: there is no material: light grey plastic is used (--material)\n"
              "a.obj: warning: its axes and unit are taken as y up and m: it is 1 x 1 x 1 m (--up, "
              "--unit)\n");
}

TEST_F(Part, of_ply_keeps_normals_and_leaves_those_that_are_none) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nproperty float nx\n"
        "property float ny\nproperty float nz\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n";
    const std::string body =
        "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 0\n3 0 1 2\n"
        "3 1 3 2\n";
    const SceneDescription scene = read_part(written("a.ply", head + body), {});
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(mesh_of(scene.shapes[0]).normals.size(), 0U);
    EXPECT_EQ(mesh_of(scene.shapes[1]).normals.size(), 3U);
    EXPECT_NE(warnings_of(scene).find("normals are zero or not finite are flat (1)"),
              std::string::npos);
}

/// Scanned parts have colours at their vertices, as sRGB.
TEST_F(Part, without_material_has_the_colours_of_its_vertices) {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 128\n3 0 1 2\n";
    const SceneDescription scene = read_part(written("a.ply", ply), {});
    const auto& matt = std::get<DiffuseMaterial>(scene.materials[scene.shapes[0].material]);
    EXPECT_TRUE(is_textured(matt));
    EXPECT_NE(warnings_of(scene).find("the colours of its vertices are used"), std::string::npos);
    const SceneDescription gold = read_part(written("a.ply", ply), of_material("gold"));
    EXPECT_NE(warnings_of(gold).find("colours of vertices are left out"), std::string::npos);
}

/// Hits of rays on the part alone.
std::vector<Vec3> hits_of(const SceneDescription& scene) {
    GeometryInput input;
    input.shapes.push_back(scene.shapes[0].placed);
    input.in_world.push_back(0);
    const Geometry geometry(std::move(input));
    std::vector<Vec3> hits;
    for (int i = 0; i < 400; ++i) {
        const Vec3 origin(0.05F * static_cast<float>(i % 20) - 0.013F,
                          0.05F * static_cast<float>(i / 20) - 0.017F, 5);
        if (const auto hit = geometry.intersect({origin, Vec3(0.01F, 0.02F, -1).normalized()}))
            hits.push_back(hit->position);
    }
    return hits;
}

std::string float_bytes(const std::vector<float>& numbers) {
    std::string bytes(numbers.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// The same triangles by OBJ, PLY, STL and glTF are hit at the same points to the last bit.
TEST_F(Part, of_all_formats_is_hit_at_the_same_points) {
    const std::vector<std::array<float, 9>> triangles = {
        {0, 0, 0, 0.9F, 0.1F, 0.3F, 0.2F, 0.8F, 0.1F},
        {0.9F, 0.1F, 0.3F, 0.8F, 0.9F, 0.7F, 0.2F, 0.8F, 0.1F}};
    std::string obj;
    std::string stl = "solid\n";
    std::vector<float> numbers;
    int vertex = 0;
    for (const auto& t : triangles) {
        stl += "facet normal 0 0 1\nouter loop\n";
        for (std::size_t k = 0; k < 9; k += 3) {
            const std::string place = std::to_string(t.at(k)) + " " + std::to_string(t.at(k + 1)) +
                                      " " + std::to_string(t.at(k + 2)) + "\n";
            stl += "vertex " + place;
            obj += "v " + place;
        }
        stl += "endloop\nendfacet\n";
        obj += "f " + std::to_string(vertex + 1) + " " + std::to_string(vertex + 2) + " " +
               std::to_string(vertex + 3) + "\n";
        vertex += 3;
        numbers.insert(numbers.end(), t.begin(), t.end());
    }
    stl += "endsolid\n";
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty float x\n"
        "property float y\nproperty float z\nelement face 2\n"
        "property list uchar uchar vertex_indices\nend_header\n" +
        float_bytes(numbers);
    ply += std::string("\3\0\1\2", 4) + std::string("\3\3\4\5", 4);
    written("a.bin", float_bytes(numbers));
    const std::string gltf =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"buffers":[{"byteLength":72,"uri":"a.bin"}],"bufferViews":[{"buffer":0,"byteLength":72}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":6}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
    ImportSettings metres;
    metres.metres_per_unit = 1;
    const std::vector<Vec3> hits = hits_of(read_part(written("a.obj", obj), metres));
    EXPECT_GT(hits.size(), 100U);
    EXPECT_EQ(hits_of(read_part(written("a.stl", stl), metres)), hits);
    EXPECT_EQ(hits_of(read_part(written("a.ply", ply), metres)), hits);
    EXPECT_EQ(hits_of(read_gltf(written("a.gltf", gltf), metres)), hits);
}

}  // namespace
}  // namespace sunfleck::engine
