// What a request changes in a scene, and what a scene adds to a request.
#include "flags/render_request.h"

#include "scene/adjust.h"
#include "scene/scene.h"

#include <algorithm>

namespace sunfleck::engine {

void adjust_view(Camera& camera, FilmDescription& film, const RenderRequest& request) {
    if (request.resolution) set_resolution(camera, film, *request.resolution);
    if (request.crop) set_crop(film, *request.crop, "--crop");
    if (request.crop_window)
        set_crop(film, pixels_of_window(*request.crop_window, film.resolution), "--cropwindow");
}

void adjust_scene(SceneDescription& scene, const RenderRequest& request) {
    adjust_view(scene.camera, scene.film, request);
    if (request.settings.energy_compensation) compensate_energy(scene.materials);
}

namespace {

/// @throws Error  for an integrator that knows no light from media that scatter or emit.
void check_media(const Scene& scene, Integrator integrator) {
    if (integrator == Integrator::sppm || integrator == Integrator::path) return;
    const std::vector<Medium>& media = scene.media().all;
    const auto is_lit = [](const Medium& medium) { return scatters(medium) || emits(medium); };
    if (std::any_of(media.begin(), media.end(), is_lit))
        throw Error(
            {"--integrator"},
            std::string(name_of(integrator)) + " does not simulate media that scatter or emit",
            "use sppm or path");
}

}  // namespace

RenderSettings settings_for(const Scene& scene, const RenderRequest& request) {
    RenderSettings settings = request.settings;
    check_media(scene, settings.integrator);
    int& max_depth = settings.transport.max_depth;
    max_depth = request.max_depth.value_or(scene.hints().max_depth.value_or(max_depth));
    settings.transport.light_groups = light_groups_of(scene, request.light_groups);
    return settings;
}

}  // namespace sunfleck::engine
