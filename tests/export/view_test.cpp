// Views are read again as they were.
#include "export/view.h"

#include "export/round_trip.h"

namespace sunfleck::engine {
namespace {

/// The view of a scene, which is written and read again.
void expect_same_view(const std::string& before_world) {
    SCOPED_TRACE(before_world);
    const SceneDescription a = read_text(before_world + "\nWorldBegin\nShape \"sphere\"");
    const SceneDescription b = again(a);
    EXPECT_EQ(b.camera.index(), a.camera.index());
    EXPECT_EQ(b.film.resolution, a.film.resolution);
    EXPECT_EQ(b.film.crop, a.film.crop);
    EXPECT_FLOAT_EQ(b.film.imaging_ratio, a.film.imaging_ratio);
    EXPECT_EQ(b.film.white, a.film.white);
    EXPECT_EQ(b.filter.kind, a.filter.kind);
    EXPECT_EQ(b.filter.radius, a.filter.radius);
    for (const Vec2d& at : {Vec2d(0.3, 0.2), Vec2d(0.4, -0.3)})
        EXPECT_EQ(filter_value(b.filter, at), filter_value(a.filter, at));
    for (const Vec2d& film : {Vec2d(3.1, 5.2), Vec2d(40, 12), Vec2d(0, 0)}) {
        const CameraRay of_a = camera_ray(a.camera, film, {0.2, 0.7});
        const CameraRay of_b = camera_ray(b.camera, film, {0.2, 0.7});
        EXPECT_LT((of_a.origin - of_b.origin).length(), 1e-12);
        EXPECT_LT((of_a.direction - of_b.direction).length(), 1e-12);
    }
}

TEST(ExportedViews, are_the_same) {
    const std::string place = "Scale -1 1 1 LookAt 1 2 3  0 0.5 0  0.1 1 0\n";
    for (const char* text :
         {R"(Camera "perspective" "float fov" 39)", R"(Camera "perspective" "float fov" 120
             "float lensradius" 0.1 "float focaldistance" 3.3)",
          R"(Camera "perspective" "float screenwindow" [ -0.3 0.9 -0.5 0.2 ])",
          R"(Camera "perspective" "float frameaspectratio" 2.5)",
          R"(Camera "orthographic" "float screenwindow" [ -3 3 -2 2 ])",
          R"(Camera "orthographic" "float lensradius" 0.2)", R"(Camera "spherical")",
          R"(Camera "spherical" "string mapping" "equirectangular")"})
        expect_same_view(place + text);
    for (const char* text :
         {R"(Film "rgb" "integer xresolution" 61 "integer yresolution" 97 "float iso" 317)",
          R"(Film "rgb" "float cropwindow" [ 0.1 0.6 0.25 0.8 ] "float whitebalance" 5000)",
          R"(PixelFilter "box")", R"(PixelFilter "triangle" "float xradius" 1.3)",
          R"(PixelFilter "gaussian" "float sigma" 0.7)",
          R"(PixelFilter "mitchell" "float B" 0.2 "float C" 0.4)",
          R"(PixelFilter "sinc" "float tau" 2)"})
        expect_same_view(text);
}

TEST(ExportedViews, say_the_angle_that_was_given) {
    const SceneDescription scene = read_text("Camera \"perspective\" \"float fov\" 40\nWorldBegin");
    EXPECT_FALSE(contains(text_of(scene), "screenwindow"));
}

TEST(ExportedViews, ask_for_what_shows_media) {
    SceneDescription scene = read_world("");
    EXPECT_TRUE(contains(integrator_text(scene), "\"sppm\""));
    scene.media.all.push_back({Spectrum::constant(1), Spectrum(), 0});
    EXPECT_TRUE(contains(integrator_text(scene), "\"volpath\""));
    scene.hints.integrator = "bdpt";
    EXPECT_TRUE(contains(integrator_text(scene), "\"bdpt\""));
}

}  // namespace
}  // namespace sunfleck::engine
