// Waiting on one thread for what another one renders.
#include "python/rendering.h"

#include <chrono>
#include <future>
#include <utility>

namespace sunfleck::python {
namespace {

/// Lets go of a Python object with the interpreter's lock held, on whatever thread.
std::shared_ptr<py::object> shared(const py::object& object) {
    return {new py::object(object), [](py::object* held) {
                const py::gil_scoped_acquire lock;
                delete held;
            }};
}

Log logger(const py::object& log) {
    if (log.is_none())
        return [](Severity, const std::string& line) {
            const py::gil_scoped_acquire lock;
            if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0)
                throw py::error_already_set();
        };
    return [log = shared(log)](Severity severity, const std::string& line) {
        const py::gil_scoped_acquire lock;
        (*log)(severity == Severity::warning ? "warning" : "info", line);
    };
}

}  // namespace

PythonRenderer::PythonRenderer(const Scene& scene, const Settings& settings, std::size_t threads,
                               const py::object& log) {
    const Log say = logger(log);
    const RendererOptions options{threads, [this, say](Severity severity, const std::string& line) {
                                      try {
                                          say(severity, line);
                                      } catch (const py::error_already_set&) {
                                          const std::lock_guard lock(guard_);
                                          raised_ = std::current_exception();
                                      }
                                  }};
    {
        const py::gil_scoped_release unlocked;
        renderer_ = std::make_unique<Renderer>(scene, settings, options);
    }
    raise();
}

PythonRenderer::~PythonRenderer() {
    const py::gil_scoped_release unlocked;
    renderer_.reset();
}

/// What a callback raised ends the render.
Renderer::Report PythonRenderer::reporter(const py::object& report) {
    if (report.is_none()) return {};
    return [this, report = shared(report)](const Progress& progress) {
        const py::gil_scoped_acquire lock;
        try {
            (*report)(progress);
        } catch (const py::error_already_set&) {
            const std::lock_guard guard(guard_);
            if (!raised_) raised_ = std::current_exception();
            renderer_->cancel();
        }
    };
}

void PythonRenderer::raise() {
    std::exception_ptr raised;
    {
        const std::lock_guard guard(guard_);
        raised = std::exchange(raised_, nullptr);
    }
    if (raised) std::rethrow_exception(raised);
}

/// Renders on another thread, so that this one can look whether Ctrl-C was pressed.
template <class Task>
bool PythonRenderer::finishes(const Task& task) {
    bool is_interrupted = false;
    Outcome outcome{};
    {
        const py::gil_scoped_release unlocked;
        std::future<Outcome> end = std::async(std::launch::async, task);
        while (end.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
            const py::gil_scoped_acquire lock;
            if (is_interrupted || PyErr_CheckSignals() == 0) continue;
            is_interrupted = true;  // Python knows what to raise
            renderer_->cancel();
        }
        outcome = end.get();
    }
    if (is_interrupted) throw py::error_already_set();
    raise();
    return outcome == Outcome::finished;
}

bool PythonRenderer::run(const py::object& report) {
    const Renderer::Report reported = reporter(report);
    return finishes([&] { return renderer_->run(reported); });
}

bool PythonRenderer::step(std::uint32_t passes, const py::object& report) {
    const Renderer::Report reported = reporter(report);
    return finishes([&] { return renderer_->step(passes, reported); });
}

void PythonRenderer::start(const py::object& report) {
    renderer_->start(reporter(report));
}

bool PythonRenderer::wait() {
    return finishes([&] { return renderer_->wait(); });
}

}  // namespace sunfleck::python
