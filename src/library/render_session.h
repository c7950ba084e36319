// A render of the library: the loop, and the calls that are allowed on other threads.
#pragma once

#include "core/parallel.h"
#include "library/scene_data.h"
#include "library/settings_data.h"
#include "render/render_loop.h"
#include "sunfleck/renderer.h"

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace sunfleck {

class RenderSession {
public:
    /// @throws Error  for settings that cannot be used with the scene.
    RenderSession(const Scene& scene, const Settings& settings, const RendererOptions& options);

    /// Renders until a limit. @param passes  more; nothing: the limits are those of the settings.
    Outcome render(std::optional<std::uint32_t> passes, const Renderer::Report& report);

    // Any thread.
    void cancel() { is_cancelled_ = true; }
    Progress progress() const;
    Picture picture() const;

    // Not while it renders.
    void clear_cancel() { is_cancelled_ = false; }
    // Another view, from which the render begins anew. If they throw, the old view stays.
    /// @param camera_for  returns the camera for a film of that size.
    void set_camera(const std::function<engine::Camera(const engine::Vec2i&)>& camera_for);
    void set_resolution(const engine::Vec2i& size);
    void set_crop(const std::optional<std::array<int, 4>>& crop);
    std::string statistics();

private:
    void set_view(engine::Camera camera, engine::FilmDescription film);
    engine::RenderHooks hooks(const Renderer::Report& report);
    void take(const engine::Progress& progress);
    void say(const std::vector<std::string>& lines) const;
    engine::RenderJob job() const { return {shown_->scene, settings_, request_.stop, 0}; }

    /// The scene as the present view shows it, and its render.
    struct Shown {
        Shown(engine::Scene view, const engine::RenderSettings& settings,
              const engine::StopSettings& stop)
            : scene(std::move(view)), loop({scene, settings, stop, 0}, std::nullopt) {}

        engine::Scene scene;
        engine::RenderLoop loop;
    };

    RendererOptions options_;
    engine::RenderRequest request_;
    engine::Scene scene_;                   // as it was given
    engine::Camera camera_;                 // of the present view, in the world
    engine::FilmDescription cropped_film_;  // at the size for which its crop was given
    std::string isa_;
    engine::RenderSettings settings_;
    engine::ThreadPool threads_;
    std::atomic<bool> is_cancelled_{false};

    mutable std::mutex guard_;  // of the film and of progress_
    std::unique_ptr<Shown> shown_;
    Progress progress_;
    std::vector<std::string> remarks_before_;  // of the present view
    std::vector<std::string> remarks_after_;   // of the last call that rendered to a limit
};

}  // namespace sunfleck
