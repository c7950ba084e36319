// OBJ files as programs write them, and as they should not.
#include "import/obj/reader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Triangles = std::vector<ObjTriangle>;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

ObjMesh parsed(const std::string& text) {
    return parse_obj(text, "a.obj");
}

std::string fault_of(const std::string& text) {
    try {
        parsed(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string remarks_of(const std::string& text) {
    std::string all;
    for (const std::string& remark : parsed(text).remarks) all += remark + ".";
    return all;
}

TEST(Obj, reads_corners_of_all_forms) {
    const std::string others = "vt 0 0\nvt .5\nvt 1 1 0\nvn 0 0 2\n";
    const ObjMesh mesh = parsed(kSquare + others +
                                "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\n"
                                "f 1/1/1 2/2/1 3/3/1\nf 1/ 2/ 3//\n");
    EXPECT_EQ(mesh.triangles, Triangles(5, {0, 1, 2}));
    const ObjTriangle none = {kNoIndex, kNoIndex, kNoIndex};
    EXPECT_EQ(mesh.uv_corners, (Triangles{none, {0, 1, 2}, none, {0, 1, 2}, none}));
    EXPECT_EQ(mesh.normal_corners, (Triangles{none, none, {0, 0, 0}, {0, 0, 0}, none}));
    EXPECT_EQ(mesh.uvs[1], Vec2(0.5F, 0));
    EXPECT_TRUE(mesh.remarks.empty());
}

TEST(Obj, counts_negative_indices_from_the_end_so_far) {
    const ObjMesh mesh = parsed(kSquare + "f -4 -3 -2\nv 9 9 9\nf -1 -5 -4\n");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {4, 0, 1}}));
    EXPECT_EQ(fault_of(kSquare + "f -5 1 2\n"),
              "a.obj:5:3: vertex -5 does not exist: there are 4; indices count from 1, or from -1 "
              "backwards");
}

/// Some writers put the vertices behind the faces.
TEST(Obj, takes_indices_of_what_comes_later) {
    EXPECT_EQ(parsed("f 1 2 3\n" + kSquare).triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(fault_of("f 1 2 3\nf 1 2 4\nf 1 5 6\n" + kSquare),
              "a.obj:3:5: vertex 5 does not exist: the file has 4; export the part again");
    EXPECT_EQ(fault_of(kSquare + "f 1/1 2/1 3/1\n"),
              "a.obj:5:3: texture coordinate 1 does not exist: the file has 0; export the part "
              "again");
    EXPECT_EQ(fault_of(kSquare + "f 1 2 4294967295\n").substr(0, 24), "a.obj:5:7: vertex 429496");
}

TEST(Obj, divides_polygons_as_their_shape_asks) {
    EXPECT_EQ(parsed(kSquare + "f 1 2 3 4\n").triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const std::string dart =
        "v 0 0 0\nv 2 0 0\nv .3 .3 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\n";
    const ObjMesh mesh = parsed(dart + "f 1/1 2/2 3/3 4/4\n");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const ObjMesh turned = parsed(dart + "f 2/2 3/3 4/4 1/1\n");
    EXPECT_EQ(turned.triangles, (Triangles{{2, 3, 0}, {1, 2, 0}}));
    EXPECT_EQ(turned.uv_corners, turned.triangles);
}

TEST(Obj, keeps_materials_and_smoothing_in_force) {
    const ObjMesh mesh = parsed(kSquare +
                                "f 1 2 3\nusemtl red paint #2 \nf 1 2 3\ns 2\nusemtl b\n"
                                "g x y\nusemtl red paint #2\nf 1 2 3\nf 1 2 4\ns off\n"
                                "usemtl\nf 1 2 3\nusemtl b\n");
    ASSERT_EQ(mesh.runs.size(), 4U);
    EXPECT_EQ(mesh.materials.size(), 2U);
    EXPECT_EQ(mesh.materials[0].name, "red paint #2");
    EXPECT_EQ(mesh.materials[0].where.text(), "a.obj:6:7");
    EXPECT_EQ(mesh.runs[0].material, kNoIndex);
    EXPECT_EQ(mesh.runs[1].material, 0U);
    EXPECT_EQ(mesh.runs[2].first, 2U);
    EXPECT_EQ(mesh.runs[2].smoothing, 2U);
    EXPECT_EQ(mesh.runs[3].first, 4U);
    EXPECT_EQ(mesh.runs[3].material, kNoIndex);
    EXPECT_EQ(mesh.runs[3].smoothing, 0U);
}

TEST(Obj, keeps_the_names_of_libraries) {
    const ObjMesh mesh = parsed("mtllib a b.mtl c.mtl\r\nmtllib d.mtl\r\n" + kSquare + "f 1 2 3");
    ASSERT_EQ(mesh.libraries.size(), 2U);
    EXPECT_EQ(mesh.libraries[0].name, "a b.mtl c.mtl");
    EXPECT_EQ(mesh.libraries[1].where.text(), "a.obj:2:7");
}

TEST(Obj, reads_lines_of_all_systems) {
    const ObjMesh mesh = parsed(
        "\xEF\xBB\xBF# by hand\r\nv 0 0 0\rv\t1 0 0 # right\nv 0 \\\n 1 0\n"
        "f 1 2\\\r\n 3");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(mesh.positions[2], Vec3d(0, 1, 0));
}

TEST(Obj, tells_what_it_leaves_out) {
    EXPECT_EQ(remarks_of("v 0 0 0 1 .5 .5\nv 1 0 0 2\nv 0 1 0 1\np 1\nl 1 2\ncstype bezier\n"
                         "f 1 2\nf 1 2 2\nf 1 2 3\nhalo 3\n"),
              "faces of fewer than three corners are left out (1)."
              "triangles with two corners at one vertex are left out (1)."
              "points are left out (1).lines are left out (1)."
              "statements of curves and surfaces are left out (1)."
              "weights of vertices other than 1 are left out (1)."
              "statements that are no OBJ are left out, first \"halo\" (1).");
    EXPECT_EQ(remarks_of("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n"),
              "faces that cross themselves, or are concave with more than 5000 corners, may be "
              "filled wrongly (1).");
}

/// In [0,1], or as bytes; vertices without are white.
TEST(Obj, reads_colours_of_vertices) {
    const ObjMesh mesh = parsed("v 0 0 0\nv 1 0 0 1 .5 0\nv 0 1 0 nan -1 .5\nv 9 9 9\nf 1 2 3\n");
    EXPECT_EQ(mesh.colours, (std::vector<Vec3>{Vec3(1), {1, 0.5F, 0}, {0, 0, 0.5F}, Vec3(1)}));
    const ObjMesh bytes = parsed("v 0 0 0 255 0 51\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
    EXPECT_EQ(bytes.colours[0], Vec3(1, 0, 0.2F));
    EXPECT_TRUE(parsed(kSquare + "f 1 2 3\n").colours.empty());
}

TEST(Obj, has_flat_triangles_where_normals_are_none) {
    const std::string text = kSquare +
                             "vn 0 0 0\nvn nan 0 0\nvn 0 0 1\nvt inf 0\n"
                             "f 1/1/3 2/1/3 3/1/1\nf 1//3 2//2 3//3\nf 1//3 2//3 3\n"
                             "f 1//3 2//3 3//3\n";
    const ObjMesh mesh = parsed(text);
    const ObjTriangle none = {kNoIndex, kNoIndex, kNoIndex};
    EXPECT_EQ(mesh.normal_corners, (Triangles{none, none, none, {2, 2, 2}}));
    EXPECT_EQ(remarks_of(text),
              "triangles whose normals are zero or not finite are flat (3)."
              "texture coordinates that are not finite became (0, 0) (1).");
}

TEST(Obj, refuses_vertices_of_faces_that_are_not_finite) {
    const std::string broken = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 1e99\n";
    EXPECT_EQ(parsed(broken + "f 1 2 3\n").triangles.size(), 1U);
    EXPECT_EQ(fault_of(broken + "f 1 2 4\n"),
              "a.obj:4:2: a vertex of a face is not finite, or too far away; export the part again "
              "without it");
}

TEST(Obj, tells_the_place_of_a_wrong_statement) {
    EXPECT_EQ(fault_of("v 0 0\nf 1 1 1\n"),
              "a.obj:1:6: the line ends where three coordinates is expected; give all numbers of "
              "the statement");
    EXPECT_EQ(fault_of("v 0,5 0 0\n"),
              "a.obj:1:3: \"0,5\" is no number; write a point in place of the comma");
    for (const char* corner : {"x", "1/x", "1/1/1/1", "/1", "1.5", "1\\2"})
        EXPECT_EQ(fault_of(kSquare + "f 1 2 " + corner + "\n"),
                  "a.obj:5:7: \"" + std::string(corner) +
                      "\" is no corner of a face; write vertex, vertex/texture, vertex//normal or "
                      "vertex/texture/normal");
    EXPECT_EQ(fault_of(kSquare + "f 0 1 2\n").substr(0, 27), "a.obj:5:3: vertex 0 does no");
    EXPECT_EQ(fault_of("s smooth\n"),
              "a.obj:1:3: \"smooth\" is no smoothing group; write its number, or off");
}

TEST(Obj, that_has_no_face_is_refused) {
    EXPECT_EQ(fault_of(kSquare),
              "a.obj: has no face with three corners; export the part as polygons");
    EXPECT_EQ(fault_of(kSquare + "l 1 2\n"),
              "a.obj: has points and lines alone, no polygons; export the part as polygons");
    EXPECT_EQ(fault_of(kSquare + "cstype bspline\nsurf 0 1 0 1 1 2 3 4\nend\n"),
              "a.obj: has curves and surfaces, but no polygons; export the part as polygons");
    EXPECT_EQ(fault_of("ply\n"),
              "a.obj: is a PLY mesh, where an OBJ mesh is read; give an OBJ mesh");
    EXPECT_NE(fault_of("").find("is empty"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine
