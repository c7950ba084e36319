// Where a camera goes, and what it still sees.
#include "camera/camera_move.h"

#include "camera/projection.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr double kDistance = 5;

/// Returns a camera at 1, 2, -5 that looks along +z with y up, or mirrored in x, or larger.
PerspectiveCamera camera_at(const Vec3d& scale = Vec3d(1)) {
    Matrix frame;
    frame.setScale(scale);
    for (int axis = 0; axis < 3; ++axis) frame[3][axis] = Vec3d(1, 2, -5)[axis];
    return make_perspective(frame, {200, 100}, 40, 2, {});
}

Vec3d place_of(const Camera& camera) {
    return std::visit([](const auto& one) { return one.camera_to_world.translation(); }, camera);
}

/// Where in the picture the pivot stands.
Vec2d pivot_seen_by(const Camera& camera) {
    const auto sight = Projection(camera).sight_of({1, 2, 0}, {0.5, 0.5});
    return sight ? sight->film : Vec2d(-1);
}

void expect_near(const Vec3d& a, const Vec3d& b) {
    EXPECT_LT((a - b).length(), 1e-9) << a << " " << b;
}

TEST(CameraMove, of_nothing_is_the_camera_itself) {
    const PerspectiveCamera camera = camera_at();
    const auto same = std::get<PerspectiveCamera>(moved(camera, {}, kDistance));
    EXPECT_TRUE(same.camera_to_world.equalWithAbsError(camera.camera_to_world, 1e-12));
}

TEST(CameraMove, turns_about_what_the_middle_of_the_picture_shows) {
    for (const Vec3d& scale : {Vec3d(1), Vec3d(-1, 1, 1), Vec3d(20)}) {
        const Camera camera = camera_at(scale);
        const Camera after = moved(camera, {.tilt = 0.3, .turn = 0.7}, kDistance);
        EXPECT_LT((pivot_seen_by(after) - Vec2d(100, 50)).length(), 1e-6);
        EXPECT_NEAR((place_of(after) - Vec3d(1, 2, 0)).length(), kDistance, 1e-9);
    }
    const Camera quarter = moved(camera_at(), {.turn = kPiDouble / 2}, kDistance);
    expect_near(place_of(quarter), {-4, 2, 0});
}

TEST(CameraMove, stays_level_when_it_turns) {
    const Camera tilted = moved(camera_at(), {.tilt = 0.4}, kDistance);
    const Camera after = moved(tilted, {.turn = 1}, kDistance);
    const Matrix frame = std::get<PerspectiveCamera>(after).camera_to_world;
    Vec3d right;
    frame.multDirMatrix(Vec3d(1, 0, 0), right);
    EXPECT_NEAR(right.y, 0, 1e-12);
    EXPECT_NEAR(place_of(after).y, place_of(tilted).y, 1e-9);
}

TEST(CameraMove, looks_around_in_its_place) {
    const Camera after = moved(camera_at(), {.pitch = 0.2, .yaw = kPiDouble / 2}, kDistance);
    expect_near(place_of(after), {1, 2, -5});
    Vec3d right;
    std::get<PerspectiveCamera>(after).camera_to_world.multDirMatrix(Vec3d(1, 0, 0), right);
    EXPECT_NEAR(right.y, 0, 1e-12);
    EXPECT_NEAR(right.x, 0, 1e-12);
}

TEST(CameraMove, comes_nearer_and_goes_aside) {
    expect_near(place_of(moved(camera_at(), {.nearer = 1}, kDistance)), {1, 2, -2.5});
    expect_near(place_of(moved(camera_at(), {.beside = {1, -0.5}}, kDistance)), {6, -0.5, -5});
    // Half as far, a step of as much of the picture is half as long.
    expect_near(place_of(moved(camera_at(), {.nearer = 1, .beside = {1, 0}}, kDistance)),
                {3.5, 2, -2.5});
}

TEST(CameraMove, of_parallel_rays_sees_less_when_it_comes_nearer) {
    OrthographicCamera camera;
    camera.screen_min = {-4, -2};
    camera.screen_max = {4, 2};
    const auto after = std::get<OrthographicCamera>(moved(camera, {.nearer = 1}, kDistance));
    EXPECT_EQ(after.screen_max, Vec2d(2, 1));
    expect_near(place_of(after), Vec3d(0));
}

TEST(CameraMove, focuses_where_there_is_a_lens) {
    PerspectiveCamera camera = camera_at();
    EXPECT_FALSE(has_lens(camera));
    EXPECT_EQ(std::get<PerspectiveCamera>(focused(camera, {1, 2, 0})).focal_distance, 1e6);
    camera.lens_radius = 0.1;
    EXPECT_TRUE(has_lens(camera));
    // The plane in focus is across the way that the camera looks, whatever is beside.
    EXPECT_NEAR(std::get<PerspectiveCamera>(focused(camera, {3, 1, 2})).focal_distance, 7, 1e-12);
    const Camera behind = focused(camera, {1, 2, -9});
    EXPECT_EQ(std::get<PerspectiveCamera>(behind).focal_distance, 1e6);
}

}  // namespace
}  // namespace sunfleck::engine
