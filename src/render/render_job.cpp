// The key of a render's films: size, settings and files, in words.
#include "render/render_job.h"

#include "camera/screen.h"
#include "film/film_metadata.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

namespace sunfleck::engine {
namespace {

/// Returns the width of a pixel over its height on a flat film, 1 if they differ by rounding only.
double pixel_aspect(const Camera& camera) {
    constexpr double kRounding = 1e-6;
    const auto on_film = [](const auto& any) {
        if constexpr (std::is_base_of_v<ScreenCamera, std::decay_t<decltype(any)>>) {
            const Vec2d pixel = pixel_of(any);
            return std::abs(pixel.x / pixel.y);
        } else {
            return 1.0;
        }
    };
    const double aspect = std::visit(on_film, camera);
    return std::abs(aspect - 1) < kRounding ? 1 : aspect;
}

}  // namespace

FilmKey key_of(const RenderJob& job) {
    const PixelWindow window = window_of(job.scene.film());
    const Vec2i whole = job.scene.film().resolution;
    FilmKey key{window.width(),    window.height(), job.settings.aovs,
                job.settings.seed, job.scene_hash,  job.settings.text()};
    key.settings += "resolution=" + std::to_string(whole.x) + "x" + std::to_string(whole.y) +
                    "\nwindow=" + std::to_string(window.x0) + "," + std::to_string(window.y0) +
                    "\n";
    if (const double aspect = pixel_aspect(job.scene.camera()); aspect != 1)
        key.settings += fmt::format("{}={}\n", kPixelAspect, static_cast<float>(aspect));
    key.light_groups = job.settings.transport.light_groups.names;
    key.sequential = is_sequential(job.settings);
    if (job.settings.integrator == Integrator::sppm && !key.sequential)
        key.alpha = job.settings.alpha;
    key.small_passes = small_passes(job.settings, key.pixels());
    return key;
}

}  // namespace sunfleck::engine
