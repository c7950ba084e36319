// The view of a look, from that of the render.
#include "apps/cli/look_aside.h"

#include "camera/camera_frame.h"
#include "export/view.h"
#include "film/film_picture.h"
#include "flags/render_request.h"
#include "render/render_loop.h"
#include "scene/adjust.h"
#include "scene/camera_view.h"
#include "scene/rendering_space.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kPixelsOfSketch = 60'000;

/// Returns a range of pixels that holds some. @param from, to  shares of them all.
std::array<int, 2> pixels_of(double from, double to, int all) {
    const int first = std::clamp(static_cast<int>(std::floor(from * all)), 0, all - 1);
    const int end = std::clamp(static_cast<int>(std::ceil(to * all)), first + 1, all);
    return {first, end};
}

std::array<int, 4> region_of(const Look& look, const PixelWindow& picture) {
    const std::array<double, 4> shares = look.region.value_or(std::array<double, 4>{0, 1, 0, 1});
    const auto [x0, x1] = pixels_of(shares[0], shares[1], picture.width());
    const auto [y0, y1] = pixels_of(shares[2], shares[3], picture.height());
    return {x0, x1, y0, y1};
}

/// Returns what the camera sees in a place of the picture: a point of rendering space.
/// @param share  of the picture, not of the film beyond it.
std::optional<Vec3d> seen_at(const Scene& scene, const PixelWindow& picture, const Vec2d& share) {
    const Vec2d film(picture.x0 + share.x * picture.width(),
                     picture.y0 + share.y * picture.height());
    const CameraRay ray = camera_ray(scene.camera(), film, {0.5, 0.5});
    const auto hit = scene.first_hit(ray);
    if (!hit) return {};
    return Vec3d(hit->position);
}

/// Returns how far what the middle of the picture shows is from the camera; where that is nothing,
/// how far the middle of the scene is.
double pivot_distance(const Scene& scene, const PixelWindow& picture) {
    const Vec3d place = frame_of(scene.camera()).translation();
    const auto seen = seen_at(scene, picture, Vec2d(0.5));
    const SceneSphere& all = scene.sphere();
    const double distance = (seen.value_or(Vec3d(all.center)) - place).length();
    return distance > 0 ? distance : std::max<double>(all.radius, 1e-6);
}

Camera in_the_world(const Scene& scene) {
    Camera camera = scene.camera();
    move_to(-scene.origin(), camera);
    return camera;
}

/// Returns the scene with the view of a look.
Scene view_of(const Scene& rendered, const Look& look, const std::array<int, 4>& region) {
    Scene scene = rendered;
    const PixelWindow picture = window_of(rendered.film());
    Camera camera = moved(in_the_world(rendered), look.move, pivot_distance(rendered, picture));
    FilmDescription film = rendered.film();
    scene.set_view(camera, film);
    if (look.focus) {
        if (const auto point = seen_at(scene, picture, *look.focus))
            camera = focused(camera, *point + scene.origin());
    }
    film.crop = {picture.x0 + region[0], picture.x0 + region[1], picture.y0 + region[2],
                 picture.y0 + region[3]};
    scene.set_view(std::move(camera), std::move(film));
    return scene;
}

/// Returns the scene with a film of fewer pixels.
Scene with_few_pixels(const Scene& seen) {
    Scene scene = seen;
    FilmDescription film = seen.film();
    Camera camera = in_the_world(seen);
    const double more = static_cast<double>(window_of(film).pixels()) / kPixelsOfSketch;
    if (more <= 1) return scene;
    const Vec2d fewer = Vec2d(film.resolution) / std::sqrt(more);
    set_resolution(
        camera, film,
        {std::max(1, static_cast<int>(fewer.x)), std::max(1, static_cast<int>(fewer.y))});
    scene.set_view(std::move(camera), std::move(film));
    return scene;
}

/// Returns the picture of a sketch from the AOVs albedo and normal.
Picture drawn(const Picture& features, const Vec3& ahead, double stops) {
    constexpr float kOfItself = 0.2F;  // brightness of what is black, and of what is seen edge-on
    const auto scale = static_cast<float>(0.7 * std::exp2(-stops));
    Picture picture{features.width, features.height, {}, {}};
    const auto& x = features.find("normal.X")->values;
    const auto& y = features.find("normal.Y")->values;
    const auto& z = features.find("normal.Z")->values;
    for (const char* name : {"R", "G", "B"}) {
        const auto& albedo = features.find(std::string("albedo.") + name)->values;
        std::vector<float>& light = picture.add(name).values;
        for (std::size_t i = 0; i < light.size(); ++i) {
            const float facing = std::abs(Vec3(x[i], y[i], z[i]).dot(ahead));
            const float colour = kOfItself + (1 - kOfItself) * albedo[i];
            light[i] = scale * colour * (kOfItself + (1 - kOfItself) * facing);
        }
    }
    return picture;
}

/// Returns the settings of a pass that asks for surfaces, and for next to no light.
RenderSettings sketching() {
    RenderSettings settings;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 1;
    settings.transport.max_depth = 1;
    settings.aovs.at(static_cast<std::size_t>(Aov::albedo)) = true;
    settings.aovs.at(static_cast<std::size_t>(Aov::normal)) = true;
    return settings;
}

}  // namespace

LookAside::LookAside(const RenderSetup& setup, const Look& look)
    : settings_(settings_for(setup.scene, setup.options.request)),
      region_(region_of(look, window_of(setup.scene.film()))),
      scene_(view_of(setup.scene, look, region_)) {}

std::string LookAside::camera_text() const {
    Warnings unused;
    return sunfleck::engine::camera_text(in_the_world(scene_), "", {scene_.path()}, unused);
}

void LookAside::run(const RenderHooks& hooks) {
    RenderLoop loop({scene_, settings_, {}, 0}, std::nullopt);
    loop.run({}, hooks);
}

Picture LookAside::sketch(double stops) const {
    const Scene scene = with_few_pixels(scene_);
    const RenderJob job{scene, sketching(), {}, 0};
    StopSettings one_pass;
    one_pass.end_pass = 1;
    RenderLoop loop(job, std::nullopt);
    loop.run(one_pass, {});
    const CameraRay middle = CameraView{scene.camera(), scene.film().resolution}.middle_ray();
    return drawn(film_picture(loop.result().film), Vec3(middle.direction), stops);
}

}  // namespace sunfleck::engine
