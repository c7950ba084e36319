// A render session, and the thread on which it may run.
#include "sunfleck/renderer.h"

#include "import/pbrt/camera.h"
#include "library/guarded.h"
#include "library/matrices.h"
#include "library/render_session.h"
#include "library/statements.h"
#include "scene/adjust.h"

#include <exception>
#include <thread>
#include <utility>

namespace sunfleck {

struct Renderer::Impl {
    Impl(const Scene& scene, const Settings& settings, const RendererOptions& options)
        : session(scene, settings, options) {}

    /// @throws Error  while it renders, and if what start() has begun has not been waited for.
    void claim() {
        if (thread.joinable() || is_running.exchange(true))
            throw Error({"Renderer"}, "a render is under way", "wait() for it");
        session.clear_cancel();
    }

    /// Ends the claim.
    struct Release {
        std::atomic<bool>& is_running;
        ~Release() { is_running = false; }
    };

    /// Runs task() while nothing else renders. @throws Error  as claim() does.
    template <class Task>
    auto while_idle(const Task& task) {
        claim();
        const Release release{is_running};
        return guarded(task);
    }

    Outcome render(std::optional<std::uint32_t> passes, const Report& report) {
        return while_idle([&] { return session.render(passes, report); });
    }

    RenderSession session;
    std::atomic<bool> is_running{false};
    std::thread thread;
    Outcome outcome = Outcome::finished;  // of the thread
    std::exception_ptr fault;
};

Renderer::Renderer(const Scene& scene, const Settings& settings, const RendererOptions& options)
    : impl_(guarded([&] { return std::make_unique<Impl>(scene, settings, options); })) {}

Renderer::~Renderer() {
    cancel();
    if (impl_->thread.joinable()) impl_->thread.join();
}

Outcome Renderer::step(std::uint32_t passes, const Report& report) {
    return impl_->render(passes, report);
}

Outcome Renderer::run(const Report& report) {
    return impl_->render({}, report);
}

void Renderer::start(const Report& report) {
    impl_->claim();
    const auto render = [impl = impl_.get(), report] {
        const Impl::Release release{impl->is_running};
        try {
            impl->outcome = guarded([&] { return impl->session.render({}, report); });
        } catch (const std::exception&) {
            impl->fault = std::current_exception();
        }
    };
    try {
        guarded([&] { impl_->thread = std::thread(render); });
    } catch (const Error&) {
        impl_->is_running = false;
        throw;
    }
}

bool Renderer::is_running() const {
    return impl_->is_running;
}

Outcome Renderer::wait() {
    if (!impl_->thread.joinable())
        throw Error({"Renderer"}, "nothing has been started", "call start() first");
    impl_->thread.join();
    if (impl_->fault) std::rethrow_exception(std::exchange(impl_->fault, nullptr));
    return impl_->outcome;
}

void Renderer::cancel() {
    impl_->session.cancel();
}

Progress Renderer::progress() const {
    return impl_->session.progress();
}

Picture Renderer::picture() const {
    return impl_->session.picture();
}

std::string Renderer::statistics() const {
    return impl_->while_idle([&] { return impl_->session.statistics(); });
}

void Renderer::set_camera(const std::string& type, const Parameters& parameters,
                          const Transform& to_world) {
    impl_->while_idle([&] {
        const engine::Statement statement = statement_of("Camera", type, parameters, "camera");
        impl_->session.change_view([&](engine::Camera& camera, engine::FilmDescription& film) {
            camera = engine::camera_of(statement, matrix_of(to_world), film.resolution);
            if (const auto unknown = statement.unused(); !unknown.empty())
                throw Error(unknown.front()->where,
                            "a camera has no parameter " + unknown.front()->title(),
                            "leave it out");
        });
    });
}

void Renderer::set_resolution(int width, int height) {
    impl_->while_idle([&] {
        const engine::Vec2i size(width, height);
        engine::check_film_size(size, {"resolution"});
        impl_->session.change_view([&](engine::Camera& camera, engine::FilmDescription& film) {
            engine::set_resolution(camera, film, size);
        });
    });
}

void Renderer::set_crop(const std::optional<std::array<int, 4>>& x0_x1_y0_y1) {
    impl_->while_idle([&] {
        impl_->session.change_view([&](engine::Camera&, engine::FilmDescription& film) {
            film.crop.reset();
            if (x0_x1_y0_y1) engine::set_crop(film, *x0_x1_y0_y1, "crop");
        });
    });
}

}  // namespace sunfleck
