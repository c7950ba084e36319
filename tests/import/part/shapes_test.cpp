// Triangles as shapes: solid and thin glass, sides, vertices.
#include "import/part/shapes.h"

#include "geometry/measure.h"
#include "part_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::kOpenTetrahedron;
using testing_support::kTetrahedron;
using testing_support::mesh_of;

class PartShapes : public testing_support::PartFolder {
protected:
    static constexpr const char* kGlass = "illum 7\nNi 1.5\nTf 0.5 1 1\n";

    static double volume_of(const TriangleMesh& mesh) {
        double volume = 0;
        for (const auto& t : mesh.triangles)
            volume += Vec3d(mesh.positions[t[0]])
                          .dot(Vec3d(mesh.positions[t[1]]).cross(Vec3d(mesh.positions[t[2]]))) /
                      6;
        return volume;
    }
    std::string kind_of(const SceneDescription& scene) const {
        return std::string(name_of(scene.materials[scene.shapes[0].material]));
    }
};

/// Some writers turn faces around; glass within out would not refract.
TEST_F(PartShapes, of_closed_glass_face_outwards) {
    const std::string vertices = kTetrahedron.substr(0, kTetrahedron.find('f'));
    for (const char* faces :
         {"f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n",
          "f 1 3 2\nf 1 4 2\nf 1 4 3\nf 2 4 3\n"}) {
        const SceneDescription scene = with_material(kGlass, vertices + faces);
        ASSERT_EQ(scene.shapes.size(), 2U);
        EXPECT_NEAR(volume_of(mesh_of(scene.shapes[0])), 1.0 / 6, 1e-9) << faces;
        EXPECT_EQ(kind_of(scene), "dielectric");
    }
}

/// Normals decide on the geometric normal's side: they are turned with the faces.
TEST_F(PartShapes, of_closed_glass_have_normals_that_point_outwards) {
    const std::string inwards =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n"
        "vn -1 -1 -1\nf 1//1 2//1 3//1\nf 1//2 4//2 2//2\n"
        "f 1//3 3//3 4//3\nf 2//4 4//4 3//4\n";
    const SceneDescription scene = with_material(kGlass, inwards);
    const TriangleMesh& mesh = mesh_of(scene.shapes[0]);
    EXPECT_NEAR(volume_of(mesh), 1.0 / 6, 1e-9);
    for (const auto& t : mesh.triangles) {
        const Vec3d a(mesh.positions[t[0]]);
        const Vec3d area = (Vec3d(mesh.positions[t[1]]) - a).cross(Vec3d(mesh.positions[t[2]]) - a);
        EXPECT_GT(area.dot(Vec3d(mesh.normals[t[0]])), 0);
    }
}

TEST_F(PartShapes, of_glass_are_solid_or_thin_by_the_rule) {
    const auto kind = [&](const std::string& mesh, GlassRule rule) {
        ImportSettings settings;
        settings.glass = rule;
        return kind_of(with_material(kGlass, mesh, settings));
    };
    EXPECT_EQ(kind(kOpenTetrahedron, GlassRule::automatic), "thindielectric");
    EXPECT_EQ(kind(kOpenTetrahedron, GlassRule::solid), "dielectric");
    EXPECT_EQ(kind(kTetrahedron, GlassRule::thin), "thindielectric");
    EXPECT_NE(warnings_of(with_material(kGlass, kOpenTetrahedron)).find("is a thin pane (--glass)"),
              std::string::npos);
}

/// A straight way of mean length through glass has the colour of its filter.
TEST_F(PartShapes, of_coloured_glass_have_a_medium_within) {
    ImportSettings inches;
    inches.metres_per_unit = 0.0254;
    const SceneDescription scene = with_material(kGlass, kTetrahedron, inches);
    ASSERT_EQ(scene.media.all.size(), 2U);
    EXPECT_EQ(scene.shapes[0].media.inside, 1U);
    const double chord = 0.0254 * 4 * (1.0 / 6) / (1.5 + std::sqrt(3) / 2);
    const Vec3 expected(static_cast<float>(std::log(2) / chord), 0, 0);
    EXPECT_NEAR(scene.media.all[1].absorption(650), Spectrum::rgb_unbounded(expected)(650), 1e-3);
}

/// The poles of a sphere as programs write them: rings of one point. They would be panes.
TEST_F(PartShapes, of_closed_glass_may_have_triangles_without_area) {
    const std::string doubled = kOpenTetrahedron + "v 0 0 1\nf 2 3 5\nf 3 4 5\nf 4 2 5\n";
    const SceneDescription scene = with_material(kGlass, doubled);
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(kind_of(scene), "dielectric");
    EXPECT_EQ(mesh_of(scene.shapes[0]).triangles.size(), 4U);
}

/// Faces of one body may have several materials: they close each other.
TEST_F(PartShapes, of_several_materials_close_each_other) {
    written("a.mtl", std::string("newmtl g\n") + kGlass + "newmtl m\nKd 1 1 1\n");
    const SceneDescription scene =
        read("mtllib a.mtl\nusemtl g\n" + kOpenTetrahedron + "usemtl m\nf 2 3 4\n");
    ASSERT_EQ(scene.shapes.size(), 3U);
    EXPECT_EQ(kind_of(scene), "dielectric");
    EXPECT_EQ(mesh_of(scene.shapes[1]).triangles.size(), 1U);
}

TEST_F(PartShapes, of_light_shine_outwards_where_they_are_closed) {
    const SceneDescription closed = with_material("Ke 2 2 2\n");
    ASSERT_TRUE(closed.shapes[0].emission);
    EXPECT_FALSE(closed.shapes[0].emission->two_sided);
    EXPECT_NEAR(closed.shapes[0].emission->radiance.luminance() * 683, 2, 1e-3);
    EXPECT_TRUE(with_material("Ke 2 2 2\n", kOpenTetrahedron).shapes[0].emission->two_sided);
}

TEST_F(PartShapes, share_vertices_whose_corners_are_the_same) {
    const SceneDescription scene = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
        "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/1\nf 1/1 2/1 3/1\nf 1/1 3/1 4\n");
    ASSERT_EQ(scene.shapes.size(), 3U);
    const TriangleMesh& flat = mesh_of(scene.shapes[0]);
    EXPECT_EQ(flat.positions.size(), 4U);
    EXPECT_EQ(flat.uvs.size(), 4U);
    EXPECT_TRUE(flat.normals.empty());
    const TriangleMesh& smooth = mesh_of(scene.shapes[1]);
    EXPECT_EQ(smooth.positions.size(), 5U) << "one place has two texture coordinates";
    EXPECT_EQ(smooth.normals.size(), 5U);
}

/// Coordinates of a survey: floats would round them to halves of a metre.
TEST_F(PartShapes, far_from_the_origin_keep_their_shape) {
    const SceneDescription scene = read(
        "v 500000.125 4500000.25 0\nv 500001.125 4500000.25 0\nv 500000.125 4500001.5 0\n"
        "f 1 2 3\n");
    const Bounds bounds = bounds_of(scene.shapes[0].placed);
    EXPECT_EQ(bounds.min, Vec3d(500000.125, 4500000.25, 0));
    EXPECT_EQ(bounds.max, Vec3d(500001.125, 4500001.5, 0));
    EXPECT_EQ(mesh_of(scene.shapes[0]).positions[1].x - mesh_of(scene.shapes[0]).positions[0].x, 1);
}

}  // namespace
}  // namespace sunfleck::engine
