// What a request changes in a scene, and what a scene adds to a request.
#include "flags/render_request.h"

#include "scene/adjust.h"
#include "scene/scene.h"

namespace sunfleck::engine {

void adjust_scene(SceneDescription& scene, const RenderRequest& request) {
    if (request.resolution) set_resolution(scene, *request.resolution);
    if (request.settings.energy_compensation) compensate_energy(scene);
    if (request.crop) set_crop(scene, *request.crop, "--crop");
    if (request.crop_window)
        set_crop(scene, pixels_of_window(*request.crop_window, scene.film.resolution),
                 "--cropwindow");
}

RenderSettings settings_for(const Scene& scene, const RenderRequest& request) {
    RenderSettings settings = request.settings;
    int& max_depth = settings.transport.max_depth;
    max_depth = request.max_depth.value_or(scene.hints().max_depth.value_or(max_depth));
    settings.transport.light_groups = light_groups_of(scene, request.light_groups);
    return settings;
}

}  // namespace sunfleck::engine
