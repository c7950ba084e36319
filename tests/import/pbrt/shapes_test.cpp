// Shapes: parameters, what is left out, and what cannot be.
#include "import/pbrt/shapes.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

template <class S>
S made(const std::string& statement) {
    return std::get<S>(read_world(statement).shapes.at(0).placed.shape);
}

const std::string kQuad = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 1 1 0 0 1 0 ] ";
const std::string kTwo = "\"integer indices\" [ 0 1 2 0 2 3 ] ";

const std::string kPatch = "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 1 1 0 ] ";
const std::string kLoop = "Shape \"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0] ";
const std::string kCurve =
    "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 1 4 0 0 5 0 0 6 0 0] ";

TEST(Shapes, spheres_have_defaults_and_parts) {
    const auto whole = made<Sphere>("Shape \"sphere\" \"float radius\" 2");
    EXPECT_EQ(whole.radius, 2);
    EXPECT_EQ(whole.z_min, -2);
    EXPECT_EQ(whole.z_max, 2);
    EXPECT_EQ(whole.phi_max, Sphere().phi_max);
    const auto part = made<Sphere>(
        "Shape \"sphere\" \"float zmin\" .5 \"float zmax\" -9 \"float "
        "phimax\" 90");
    EXPECT_EQ(part.z_min, -1);
    EXPECT_EQ(part.z_max, 0.5);
    EXPECT_NEAR(part.phi_max, kPiDouble / 2, 1e-15);
}

TEST(Shapes, disks_have_defaults_and_parts) {
    const auto whole = made<Disk>("Shape \"disk\"");
    EXPECT_EQ(whole.height, 0);
    EXPECT_EQ(whole.radius, 1);
    EXPECT_EQ(whole.inner_radius, 0);
    const auto part = made<Disk>(
        "Shape \"disk\" \"float height\" 3 \"float radius\" 2 \"float "
        "innerradius\" 1 \"float phimax\" 720");
    EXPECT_EQ(part.height, 3);
    EXPECT_EQ(part.inner_radius, 1);
    EXPECT_EQ(part.phi_max, Disk().phi_max);
}

TEST(Shapes, meshes_have_vertices_and_what_goes_with_them) {
    const auto mesh = made<TriangleMesh>(
        kQuad + kTwo +
        "\"normal N\" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] \"point2 uv\" [ 0 0 1 0 1 1 0 1 "
        "] \"vector3 S\" [ 1 0 0 1 0 0 1 0 0 1 0 0 ] \"integer faceIndices\" [ 0 "
        "1 ]");
    EXPECT_EQ(mesh.positions.at(2), Vec3(1, 1, 0));
    const std::array<std::uint32_t, 3> second = {0, 2, 3};
    EXPECT_EQ(mesh.triangles.at(1), second);
    EXPECT_EQ(mesh.normals.size(), 4U);
    EXPECT_EQ(mesh.uvs.at(3), Vec2(0, 1));
    EXPECT_EQ(mesh.tangents.at(0), Vec3(1, 0, 0));
    const auto one = made<TriangleMesh>("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]");
    EXPECT_EQ(one.triangles.size(), 1U);
}

TEST(Shapes, ply_files_are_read_from_the_main_folder) {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
        "0\n0 1 0\n3 0 1 2\n";
    const FileAccess files = memory_access({{"folder/a/b.ply", ply}});
    const SceneDescription scene = read_pbrt_text(
        "WorldBegin Shape \"plymesh\" \"string filename\" \"a/b.ply\"", "folder/main.pbrt", files);
    EXPECT_EQ(std::get<TriangleMesh>(scene.shapes.at(0).placed.shape).triangles.size(), 1U);
    const std::vector<std::string> read = {"folder/a/b.ply"};
    EXPECT_EQ(scene.files, read);
}

TEST(Shapes, cylinders_have_defaults_and_parts) {
    const auto whole = made<Cylinder>("Shape \"cylinder\"");
    EXPECT_EQ(whole.radius, 1);
    EXPECT_EQ(whole.z_min, -1);
    EXPECT_EQ(whole.z_max, 1);
    EXPECT_EQ(whole.phi_max, Cylinder().phi_max);
    const auto part = made<Cylinder>(
        "Shape \"cylinder\" \"float radius\" 2 \"float zmin\" 5 \"float zmax\" -3 \"float "
        "phimax\" 90");
    EXPECT_EQ(part.radius, 2);
    EXPECT_EQ(part.z_min, -3);
    EXPECT_EQ(part.z_max, 5);
    EXPECT_NEAR(part.phi_max, kPiDouble / 2, 1e-15);
}

TEST(Shapes, bilinear_meshes_have_patches) {
    const auto one = made<BilinearMesh>(kPatch);
    const std::array<std::uint32_t, 4> corners = {0, 1, 2, 3};
    EXPECT_EQ(one.patches, std::vector{corners});
    const auto mesh = made<BilinearMesh>(
        kPatch +
        "\"integer indices\" [ 0 1 2 3 3 2 1 0 ] \"normal N\" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] "
        "\"point2 uv\" [ 0 0 1 0 0 1 1 1 ] \"integer faceIndices\" [ 0 1 ]");
    EXPECT_EQ(mesh.patches.size(), 2U);
    EXPECT_EQ(mesh.normals.size(), 4U);
    EXPECT_EQ(mesh.uvs.at(3), Vec2(1, 1));
}

TEST(Shapes, subdivided_meshes_have_levels) {
    const std::string flat = "Shape \"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0] ";
    const std::string indices = "\"integer indices\" [ 0 1 2 ] ";
    EXPECT_EQ(made<TriangleMesh>(flat + indices).triangles.size(), 64U);
    const auto one = made<TriangleMesh>(flat + indices + "\"integer levels\" 1");
    EXPECT_EQ(one.triangles.size(), 4U);
    EXPECT_EQ(one.normals.size(), 6U);
}

TEST(Shapes, curves_are_bezier_segments) {
    const auto cubic = made<Curves>(kCurve + "\"float width0\" 2 \"float width1\" 4");
    EXPECT_EQ(cubic.kind, CurveKind::flat);
    ASSERT_EQ(cubic.segments.size(), 2U);
    EXPECT_EQ(cubic.segments[1].points[0], Vec3(3, 0, 1));
    EXPECT_EQ(cubic.segments[0].width[0], 2);
    EXPECT_EQ(cubic.segments[0].width[1], 3);
    EXPECT_EQ(cubic.segments[1].width[1], 4);
    const auto quadratic = made<Curves>(
        "Shape \"curve\" \"point3 P\" [0 0 0 3 0 0 3 3 0] \"integer degree\" 2 "
        "\"string type\" \"cylinder\" \"integer splitdepth\" 5");
    EXPECT_EQ(quadratic.kind, CurveKind::cylinder);
    EXPECT_EQ(quadratic.segments.at(0).width[0], 1);
    const std::array<Vec3, 4> raised = {Vec3(0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(3, 3, 0)};
    EXPECT_EQ(quadratic.segments.at(0).points, raised);
    const auto ribbon =
        made<Curves>(kCurve + "\"string type\" \"ribbon\" \"normal N\" [0 0 1 0 1 0 1 0 0]");
    EXPECT_EQ(ribbon.segments.at(1).normal[0], Vec3(0, 1, 0));
    EXPECT_EQ(ribbon.segments.at(1).normal[1], Vec3(1, 0, 0));
}

/// Points on the straight line x = 1, 2, 3 ...: the spline runs evenly along it, and its segments
/// join.
TEST(Shapes, splines_become_bezier_segments) {
    for (const int degree : {2, 3}) {
        const auto curve =
            made<Curves>("Shape \"curve\" \"string basis\" \"bspline\" \"integer degree\" " +
                         std::to_string(degree) + " \"point3 P\" [1 0 0 2 0 0 3 0 0 4 0 0 5 0 7]");
        ASSERT_EQ(curve.segments.size(), degree == 2 ? 3U : 2U);
        const float start = degree == 2 ? 1.5F : 2;
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(curve.segments[0].points.at(i).x, start + float(i) / 3, 1e-6);
        for (std::size_t s = 1; s < curve.segments.size(); ++s)
            EXPECT_EQ(curve.segments[s - 1].points[3], curve.segments[s].points[0]);
        EXPECT_GT(curve.segments.back().points[3].z, 1);
    }
}

TEST(Shapes, curves_in_a_row_are_one_shape) {
    const SceneDescription scene =
        read_world(kCurve + kCurve + "Translate 1 0 0 " + kCurve + "ReverseOrientation " + kCurve +
                   "Shape \"sphere\"" + kCurve);
    ASSERT_EQ(scene.shapes.size(), 5U);
    EXPECT_EQ(std::get<Curves>(scene.shapes[0].placed.shape).segments.size(), 4U);
    EXPECT_EQ(std::get<Curves>(scene.shapes[4].placed.shape).segments.size(), 2U);
    const SceneDescription lit = read_world("AreaLightSource \"diffuse\" " + kCurve);
    EXPECT_FALSE(lit.shapes.at(0).emission);
    EXPECT_EQ(warnings_with(lit, "curves emit no light"), 1);
    EXPECT_EQ(warnings_with(read_world(kCurve + "\"normal N\" [0 0 1]"), "not a ribbon"), 1);
}

TEST(Shapes, with_alpha_are_there_in_part) {
    EXPECT_TRUE(read_world("Shape \"sphere\" \"float alpha\" 0").shapes.empty());
    EXPECT_FALSE(read_world("Shape \"sphere\" \"float alpha\" 1").shapes.at(0).placed.cover);
    const SceneDescription half = read_world("Shape \"sphere\" \"float alpha\" .25");
    ASSERT_TRUE(half.shapes.at(0).placed.cover);
    EXPECT_EQ(half.shapes.at(0).placed.cover(Hit{}), 0.25F);
    EXPECT_EQ(warnings_with(half, "alpha"), 0);
    const SceneDescription mask = read_world(
        "Texture \"m\" \"float\" \"bilerp\" \"float v01\" 0 \"float v10\" 1 Shape "
        "\"sphere\" \"texture alpha\" \"m\"");
    Hit hit;
    hit.uv = {0.75F, 0.5F};
    EXPECT_EQ(mask.shapes.at(0).placed.cover(hit), 0.75F);
}

TEST(Shapes, that_emit_are_seen_as_far_as_they_are_there) {
    const SceneDescription light =
        read_world("AreaLightSource \"diffuse\" Shape \"sphere\" \"float alpha\" 0");
    EXPECT_TRUE(light.shapes.at(0).unseen);
    EXPECT_TRUE(light.shapes.at(0).emission);
    EXPECT_TRUE(light.warnings.entries().empty());
    const SceneDescription half =
        read_world("AreaLightSource \"diffuse\" Shape \"sphere\" \"float alpha\" .5");
    EXPECT_EQ(half.shapes.at(0).placed.cover({}), 0.5F);
    EXPECT_FALSE(half.shapes.at(0).unseen);
    EXPECT_TRUE(half.warnings.entries().empty());
}

TEST(Shapes, take_defaults_of_their_block) {
    const SceneDescription scene = read_world(
        "AttributeBegin Attribute \"shape\" \"float radius\" 3 \"float alpha\" 1 Shape \"sphere\" "
        "Shape \"sphere\" \"float radius\" 4 AttributeEnd Shape \"sphere\"");
    const auto radius = [&](std::size_t i) {
        return std::get<Sphere>(scene.shapes.at(i).placed.shape).radius;
    };
    EXPECT_EQ(radius(0), 3);
    EXPECT_EQ(radius(1), 4);
    EXPECT_EQ(radius(2), 1);
}

TEST(Shapes, in_objects_stand_once_and_shine_not) {
    const SceneDescription scene = read_world(
        "ObjectInstance \"o\" Translate 1 0 0 ObjectBegin \"o\" Translate 0 1 0 AreaLightSource "
        "\"diffuse\" Shape \"sphere\" Shape \"disk\" ObjectEnd Scale 2 2 2 ObjectInstance \"o\" "
        "Shape \"sphere\"");
    ASSERT_EQ(scene.objects.size(), 1U);
    ASSERT_EQ(scene.objects[0].size(), 2U);
    EXPECT_EQ(Vec3d(0) * scene.objects[0][0].placed.to_world, Vec3d(1, 1, 0));
    EXPECT_FALSE(scene.objects[0][0].emission);
    EXPECT_EQ(warnings_with(scene, "area lights in objects"), 2);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[0].to_world, Matrix());
    EXPECT_EQ(Vec3d(1, 1, 1) * scene.instances[1].to_world, Vec3d(3, 2, 2));
    ASSERT_EQ(scene.shapes.size(), 1U);
    EXPECT_FALSE(scene.shapes[0].emission);
}

TEST(Shapes, that_cannot_be_are_errors) {
    const std::vector<std::string> broken = {
        "Shape \"cube\"",
        "Shape \"sphere\" \"float radius\" -1",
        "Shape \"sphere\" \"float radius\" 0",
        "Shape \"sphere\" \"float zmin\" 2 \"float zmax\" 3",
        "Shape \"sphere\" \"float phimax\" 0",
        "Shape \"disk\" \"float innerradius\" 1",
        "Shape \"trianglemesh\"",
        "Shape \"plymesh\"",
        kQuad,
        kQuad + "\"integer indices\" [ 0 1 ]",
        kQuad + "\"integer indices\" [ 0 1 4 ]",
        kQuad + "\"integer indices\" [ 0 1 -1 ]",
        kQuad + kTwo + "\"normal N\" [ 0 0 1 ]",
        kQuad + kTwo + "\"point2 uv\" [ 0 0 ]",
        kQuad + kTwo + "\"vector3 S\" [ 0 0 1 ]",
        kQuad + kTwo + "\"vector3 N\" [ 0 0 1 0 0 1 0 0 1 0 0 1 ]",
        "Shape \"sphere\" \"texture alpha\" \"x\"",
        "Shape \"cylinder\" \"float radius\" 0",
        "Shape \"cylinder\" \"float zmin\" 1",
        "Shape \"bilinearmesh\"",
        kPatch + "\"integer indices\" [ 0 1 2 ]",
        kPatch + "\"integer indices\" [ 0 1 2 4 ]",
        kPatch + "\"point2 uv\" [ 0 0 ]",
        "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]",
        "Shape \"loopsubdiv\"",
        kLoop + "\"integer indices\" [ 0 1 2 0 1 2 ]",
        kLoop + "\"integer levels\" -1",
        kLoop + "\"integer levels\" 15",
        "Shape \"curve\"",
        "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 2 0 0]",
        kCurve + "\"integer degree\" 4",
        kCurve + "\"string basis\" \"hermite\"",
        kCurve + "\"string type\" \"tube\"",
        kCurve + "\"float width1\" -1",
        kCurve + "\"string type\" \"ribbon\"",
        kCurve + "\"string type\" \"ribbon\" \"normal N\" [0 0 1 0 0 0 0 0 1]"};
    for (const std::string& text : broken) EXPECT_NE(world_error(text), "") << text;
}

TEST(Shapes, normals_that_are_no_numbers_are_left_out) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float "
        "z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list "
        "uchar int vertex_indices\nend_header\n0 0 0 nan nan nan\n1 0 0 0 0 1\n0 1 0 0 inf 1\n3 0 "
        "1 "
        "2\n";
    const SceneDescription scene =
        read_world("Shape \"plymesh\" \"string filename\" \"a.ply\"", {{"a.ply", text}});
    const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).placed.shape);
    EXPECT_EQ(mesh.normals, (std::vector<Vec3>{Vec3(0), Vec3(0, 0, 1), Vec3(0)}));
    EXPECT_EQ(warnings_with(scene, "2 normals in \"a.ply\" are not finite"), 1);
}

}  // namespace
}  // namespace sunfleck::engine
