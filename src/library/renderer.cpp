// A render session, and the thread on which it may run.
#include "sunfleck/renderer.h"

#include "import/pbrt/camera.h"
#include "library/guarded.h"
#include "library/matrices.h"
#include "library/render_session.h"
#include "library/statements.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace sunfleck {
namespace {

[[noreturn]] void refuse(const engine::Parameter& of_camera) {
    if (of_camera.name.starts_with("shutter"))
        throw Error(of_camera.where, "a view keeps the exposure of the scene's film",
                    "leave " + of_camera.title() + " out, or build the scene with it");
    throw Error(of_camera.where, "a camera has no parameter " + of_camera.title(), "leave it out");
}

}  // namespace

struct Renderer::Impl {
    Impl(const Scene& scene, const Settings& settings, const RendererOptions& options)
        : session(scene, settings, options) {}

    /// @throws Error  while it renders, and if what start() has begun has not been waited for.
    void claim() {
        if (is_started || is_running.exchange(true))
            throw Error({"Renderer"}, "a render is under way",
                        "make this call after run() or wait() has returned");
        session.clear_cancel();
    }

    /// Ends the claim.
    class Release {
    public:
        explicit Release(std::atomic<bool>& is_running) : is_running_(is_running) {}
        ~Release() { is_running_ = false; }
        Release(const Release&) = delete;
        Release& operator=(const Release&) = delete;
        Release(Release&&) = delete;
        Release& operator=(Release&&) = delete;

    private:
        std::atomic<bool>& is_running_;
    };

    /// Runs task() while nothing else renders. @throws Error  as claim() does.
    template <class Task>
    auto while_idle(const Task& task) {
        claim();
        const Release release(is_running);
        return guarded(task);
    }

    Outcome render(std::optional<std::uint32_t> passes, const Report& report) {
        return while_idle([&] { return session.render(passes, report); });
    }

    /// What start() has begun, on its thread.
    void render_on_thread(const Report& report) {
        const Release release(is_running);
        thread_id = std::this_thread::get_id();
        try {
            outcome = guarded([&] { return session.render({}, report); });
        } catch (const Error&) {
            fault = std::current_exception();
        }
    }

    RenderSession session;
    std::atomic<bool> is_running{false};
    std::atomic<bool> is_started{false};  // from start() to the end of wait()
    std::atomic<std::thread::id> thread_id;
    std::thread thread;
    std::mutex waits;                     // held by the thread that waits
    Outcome outcome = Outcome::finished;  // of the thread
    std::exception_ptr fault;
};

Renderer::Renderer(const Scene& scene, const Settings& settings, const RendererOptions& options)
    : impl_(guarded([&] { return std::make_shared<Impl>(scene, settings, options); })) {}

Renderer::~Renderer() {
    cancel();
    if (!impl_->thread.joinable()) return;
    // The thread may hold the last owner of the renderer, in its report: it cannot wait for itself.
    if (impl_->thread_id == std::this_thread::get_id())
        impl_->thread.detach();
    else
        impl_->thread.join();
}

Outcome Renderer::step(std::uint32_t passes, const Report& report) {
    return impl_->render(passes, report);
}

Outcome Renderer::run(const Report& report) {
    return impl_->render({}, report);
}

void Renderer::start(const Report& report) {
    impl_->claim();
    const auto render = [impl = impl_, report] { impl->render_on_thread(report); };
    try {
        guarded([&] { impl_->thread = std::thread(render); });
    } catch (const Error&) {
        impl_->is_running = false;
        throw;
    }
    impl_->is_started = true;
}

bool Renderer::is_running() const {
    return impl_->is_running;
}

Outcome Renderer::wait() {
    if (!impl_->is_started)
        throw Error({"Renderer"}, "nothing has been started", "call start() first");
    if (impl_->thread_id == std::this_thread::get_id())
        throw Error({"Renderer"}, "a report cannot wait() for its own render", "return from it");
    const std::unique_lock lock(impl_->waits, std::try_to_lock);
    if (!lock || !impl_->is_started)
        throw Error({"Renderer"}, "another thread waits for the render", "wait() on one thread");
    impl_->thread.join();
    impl_->is_started = false;
    impl_->thread_id = std::thread::id();
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
        impl_->session.set_camera([&](const engine::Vec2i& resolution) {
            engine::Camera camera = engine::camera_of(statement, matrix_of(to_world), resolution);
            if (const auto unused = statement.unused(); !unused.empty()) refuse(*unused.front());
            return camera;
        });
    });
}

void Renderer::set_resolution(int width, int height) {
    impl_->while_idle([&] { impl_->session.set_resolution({width, height}); });
}

void Renderer::set_crop(const std::optional<std::array<int, 4>>& x0_x1_y0_y1) {
    impl_->while_idle([&] { impl_->session.set_crop(x0_x1_y0_y1); });
}

}  // namespace sunfleck
