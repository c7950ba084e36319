// Matrices of the directives, by what they do to points.
#include "import/pbrt/transforms.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

/// Where a point of the current frame lands in the world after these directives.
Vec3d placed(const std::string& directives, const Vec3d& point) {
    const SceneDescription scene = read_world(directives + " Shape \"sphere\"");
    return point * scene.shapes.at(0).placed.to_world;
}

void expect_near(const Vec3d& a, const Vec3d& b) {
    EXPECT_TRUE(a.equalWithAbsError(b, 1e-12)) << a << " against " << b;
}

TEST(Transforms, the_last_directive_acts_first) {
    expect_near(placed("Translate 1 2 3 Scale 2 2 2", {1, 1, 1}), {3, 4, 5});
    expect_near(placed("Scale 2 2 2 Translate 1 2 3", {1, 1, 1}), {4, 6, 8});
    expect_near(placed("Translate 1 0 0 Identity", {1, 1, 1}), {1, 1, 1});
}

TEST(Transforms, rotate_turns_x_to_y_about_z) {
    expect_near(placed("Rotate 90 0 0 2", {1, 0, 0}), {0, 1, 0});
    expect_near(placed("Rotate 90 1 0 0", {0, 1, 0}), {0, 0, 1});
    expect_near(placed("Rotate 90 0 1 0", {0, 0, 1}), {1, 0, 0});
    expect_near(placed("Rotate 120 1 1 1", {1, 0, 0}), {0, 1, 0});
}

TEST(Transforms, sixteen_numbers_stand_column_by_column) {
    const std::string m = "[ 0 1 0 0  -1 0 0 0  0 0 1 0  5 6 7 1 ]";
    expect_near(placed("Translate 9 9 9 Transform " + m, {1, 0, 0}), {5, 7, 7});
    expect_near(placed("Translate 1 1 1 ConcatTransform " + m, {1, 0, 0}), {6, 8, 8});
    expect_near(placed("Transform [ 2 0 0 0 0 2 0 0 0 0 2 0 2 4 6 2 ]", {1, 1, 1}), {2, 3, 4});
}

TEST(Transforms, look_at_is_left_handed) {
    const Matrix m = *look_at({0, 0, -5}, {0, 0, 0}, {0, 1, 0});
    expect_near(Vec3d(0, 0, 0) * m, {0, 0, 5});
    expect_near(Vec3d(1, 2, -5) * m, {1, 2, 0});
    EXPECT_FALSE(look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0}));
    EXPECT_FALSE(look_at({0, 0, 0}, {0, 3, 0}, {0, 1, 0}));
    EXPECT_FALSE(look_at({0, 0, 0}, {0, 3, 0}, {0, 0, 0}));
}

TEST(Transforms, named_systems_come_back) {
    expect_near(placed("Translate 1 2 3 CoordinateSystem \"a\" Identity CoordSysTransform \"a\"",
                       {0, 0, 0}),
                {1, 2, 3});
    expect_near(placed("Translate 1 2 3 CoordSysTransform \"world\"", {0, 0, 0}), {0, 0, 0});
    const SceneDescription camera = read_text(
        "LookAt 4 5 6 4 5 7 0 1 0 Camera \"perspective\"\n"
        "WorldBegin CoordSysTransform \"camera\"\n"
        "Shape \"sphere\"");
    expect_near(Vec3d(0, 0, 1) * camera.shapes[0].placed.to_world, {4, 5, 7});
    EXPECT_EQ(warnings_with(read_world("CoordSysTransform \"nowhere\""), "nowhere"), 1);
}

TEST(Transforms, blocks_bring_matrix_and_orientation_back) {
    const SceneDescription scene = read_world(
        "AttributeBegin Translate 1 0 0 ReverseOrientation Shape \"sphere\" "
        "AttributeEnd Shape \"sphere\" TransformBegin Translate 2 0 0 TransformEnd "
        "ReverseOrientation ReverseOrientation Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].placed.to_world[3][0], 1);
    EXPECT_TRUE(scene.shapes[0].placed.flip);
    EXPECT_EQ(scene.shapes[1].placed.to_world, Matrix());
    EXPECT_FALSE(scene.shapes[1].placed.flip);
    EXPECT_EQ(scene.shapes[2].placed.to_world, Matrix());
    EXPECT_FALSE(scene.shapes[2].placed.flip);
}

/// As pbrt-v4 does: quadrics in their own frame, meshes by their corners in the world.
TEST(Transforms, that_mirror_turn_the_normals_of_quadrics_and_curves_alone) {
    const auto is_turned = [](const std::string& before, const std::string& shape) {
        return read_world(before + " Shape " + shape).shapes[0].placed.flip;
    };
    const std::string mesh =
        R"("trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "integer indices" [0 1 2])";
    for (const std::string shape : {R"("sphere")", R"("disk")", R"("cylinder")"}) {
        EXPECT_TRUE(is_turned("Scale 1 1 -1", shape)) << shape;
        EXPECT_FALSE(is_turned("ReverseOrientation Scale 1 1 -1", shape)) << shape;
        EXPECT_FALSE(is_turned("Scale -1 -1 1", shape)) << shape;
        EXPECT_FALSE(is_turned("AreaLightSource \"diffuse\" Scale 1 1 -1", shape)) << shape;
    }
    EXPECT_FALSE(is_turned("Scale 1 1 -1", mesh));
    EXPECT_TRUE(is_turned("ReverseOrientation Scale 1 1 -1", mesh));
}

TEST(Transforms, motion_stands_in_the_middle_and_says_so) {
    const SceneDescription scene = read_world(
        "ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime "
        "Translate 2 0 0 ActiveTransform All Scale 3 3 3 Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].placed.to_world[3][0], 1.5);
    EXPECT_NEAR(scene.shapes[0].placed.to_world[0][0], 3, 1e-14);
    EXPECT_EQ(warnings_with(scene, "motion is not simulated"), 1);
    const SceneDescription still = read_world(
        "ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime "
        "Translate 1 0 0 ActiveTransform All Shape \"sphere\"");
    EXPECT_EQ(warnings_with(still, "motion"), 0);
}

/// Turns of less than half a circle go the shorter way; mirrors and stretches are mixed.
TEST(Transforms, between_two_matrices) {
    const Matrix a = scaling({1, 2, -1}) * rotation(20, {1, 2, 3}) * translation({1, 0, 0});
    const Matrix b = scaling({3, 2, -1}) * rotation(140, {1, 2, 3}) * translation({3, 8, 0});
    EXPECT_EQ(between(a, b, 0), a);
    EXPECT_EQ(between(a, b, 1), b);
    for (const double share : {0.25, 0.5, 0.9}) {
        const Matrix expected = scaling({1 + 2 * share, 2, -1}) *
                                rotation(20 + 120 * share, {1, 2, 3}) *
                                translation({1 + 2 * share, 8 * share, 0});
        EXPECT_TRUE(between(a, b, share).equalWithAbsError(expected, 1e-12)) << share;
    }
    const Matrix back = between(rotation(170, {0, 0, 1}), rotation(190, {0, 0, 1}), 0.5);
    EXPECT_TRUE(back.equalWithAbsError(rotation(180, {0, 0, 1}), 1e-12));
}

/// The middle of the exposure between the times of the two matrices; held outside of them.
TEST(Transforms, times_of_shutter_and_matrices) {
    const auto place = [](const std::string& shutter, const std::string& times) {
        const SceneDescription scene = read_pbrt_text(
            times + " Camera \"perspective\" " + shutter +
                " WorldBegin ActiveTransform EndTime Translate 8 0 0 ActiveTransform All "
                "Shape \"sphere\"",
            "main.pbrt", memory_access({}));
        return scene.shapes.at(0).placed.to_world[3][0];
    };
    const std::string early = "\"float shutterclose\" .5";
    EXPECT_EQ(place("", ""), 4);
    EXPECT_EQ(place(early, ""), 2);
    EXPECT_EQ(place(early, "TransformTimes 0 .5"), 4);
    EXPECT_EQ(place(early, "TransformTimes .25 2"), 0);
    EXPECT_EQ(place("\"float shutteropen\" .5", "TransformTimes 0 .5"), 8);
    EXPECT_EQ(place("", "TransformTimes .25 .25"), 8);
}

TEST(Transforms, without_an_inverse_are_errors) {
    EXPECT_TRUE(contains(world_error("Scale 1 0 1"), "main.pbrt:2:1: Scale: the matrix has no"));
    EXPECT_NE(world_error("Scale 1e-30 1e-30 1e-30 Scale 1e-38 1e-38 1e-38 "
                          "Scale 1e-38 1e-38 1e-38 Scale 1e-38 1e-38 1e-38"),
              "");
    EXPECT_NE(world_error("Rotate 30 0 0 0"), "");
    EXPECT_NE(world_error("Transform [ 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 ]"), "");
    EXPECT_NE(world_error("Transform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 ]"), "");
    EXPECT_NE(world_error("Transform [ 1 0 0 0 ]"), "");
}

TEST(Transforms, beyond_floats_are_told_at_what_they_place) {
    const std::string far = "Translate 3e38 0 0 Translate 3e38 0 0 ";
    const std::string wide = "Scale 1e20 1e20 1e20 Scale 1e20 1e20 1e20 ";
    for (const std::string& world :
         {far + "LightSource \"point\"", wide + "LightSource \"spot\"", far + "Shape \"sphere\"",
          wide + "Shape \"sphere\"",
          std::string("Scale 1e20 1e20 1e20 LightSource \"point\" \"point3 from\" [ 1e20 0 0 ]")}) {
        const std::string fault = world_error(world);
        EXPECT_TRUE(contains(fault, "main.pbrt:2:") && contains(fault, "3.4e38")) << world << fault;
    }
    for (const std::string& before : {far, std::string("Scale 1e-20 1e-20 1e-20 Scale 1e-20 1 1 ")})
        EXPECT_TRUE(contains(error_of(before + "Camera \"perspective\" WorldBegin"), "3.4e38"))
            << before;
    EXPECT_EQ(world_error("Translate 3e38 0 0 LightSource \"point\" Scale 1e-15 1e-15 1e-15 "
                          "Shape \"sphere\""),
              "");
}

}  // namespace
}  // namespace sunfleck::engine
