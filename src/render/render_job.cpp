// The key of a render's films: size, settings and files, in words.
#include "render/render_job.h"

namespace sunfleck::engine {

FilmKey key_of(const RenderJob& job) {
    const PixelWindow window = window_of(job.scene.film());
    const Vec2i whole = job.scene.film().resolution;
    FilmKey key{window.width(),    window.height(), job.settings.aovs,
                job.settings.seed, job.scene_hash,  job.settings.text()};
    key.settings += "resolution=" + std::to_string(whole.x) + "x" + std::to_string(whole.y) +
                    "\nwindow=" + std::to_string(window.x0) + "," + std::to_string(window.y0) +
                    "\n";
    key.light_groups = job.settings.transport.light_groups.names;
    key.sequential = is_sequential(job.settings);
    if (job.settings.integrator == Integrator::sppm && !key.sequential)
        key.alpha = job.settings.alpha;
    key.small_passes = small_passes(job.settings, key.pixels());
    return key;
}

}  // namespace sunfleck::engine
