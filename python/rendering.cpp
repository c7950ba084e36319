// Waiting on one thread for what another one renders.
#include "python/rendering.h"

#include <chrono>
#include <future>
#include <utility>

namespace sunfleck::python {
namespace {

using std::chrono::milliseconds;

std::shared_ptr<Callback> callback_of(const py::object& function) {
    return function.is_none() ? nullptr : std::make_shared<Callback>(function);
}

Raised raised_by(const std::shared_ptr<Callback>& callback) {
    return callback ? callback->take() : std::nullopt;
}

}  // namespace

PythonRenderer::PythonRenderer(const Scene& scene, const Settings& settings, std::size_t threads,
                               const py::object& log)
    : log_(std::make_shared<Callback>(log)) {
    const Log say = [log = log_](Severity severity, const std::string& line) {
        (*log)(severity == Severity::warning ? "warning" : "info", line);
    };
    renderer_ = unlocked([&] {
        return std::make_shared<Renderer>(scene, settings, RendererOptions{threads, say});
    });
    end_with_python(renderer_);
    raise_first({log_->take()});
}

/// The thread of start() may wait for the lock.
PythonRenderer::~PythonRenderer() {
    unlocked([&] { renderer_.reset(); });
}

/// What a report raises ends the render. The report may be what lets go of the renderer.
Renderer::Report PythonRenderer::reporter(const SharedCallback& report) const {
    if (!report) return {};
    return [report, renderer = std::weak_ptr(renderer_)](const Progress& progress) {
        if ((*report)(progress)) return;
        if (const auto alive = renderer.lock()) alive->cancel();
    };
}

/// Calls is_done(), which waits a little, with the lock released until it is true. Ctrl-C cancels
/// the render; a second one does not wait for a report that does not return.
/// @return what the first has raised.
template <class Done>
Raised PythonRenderer::wait_until(const Done& is_done) {
    Raised interrupt;
    for (bool is_over = false; !is_over;) {
        {
            const py::gil_scoped_release released;
            is_over = is_done();
        }
        if (PyErr_CheckSignals() != 0) {
            const py::error_already_set raised;
            if (interrupt) throw py::error_already_set(raised);
            interrupt = raised;
        }
        if (interrupt) renderer_->cancel();
    }
    return interrupt;
}

/// Raises what has ended the render, or returns whether it is finished.
template <class Result>
bool PythonRenderer::finishes(const Raised& interrupt, const SharedCallback& report,
                              const Result& result) {
    try {
        const Outcome outcome = result();
        raise_first({interrupt, raised_by(report), log_->take()});
        return outcome == Outcome::finished;
    } catch (const Error&) {
        raise_first({interrupt, raised_by(report)});
        throw;
    }
}

/// Renders on another thread, so that this one can look whether Ctrl-C was pressed.
template <class Task>
bool PythonRenderer::renders(const py::object& report, const Task& task) {
    const LockClaim claim;
    if (!claim) return false;
    const SharedCallback callback = callback_of(report);
    std::packaged_task<Outcome()> work([task, renderer = renderer_, reported = reporter(callback)] {
        return task(*renderer, reported);
    });
    std::future<Outcome> end = work.get_future();
    std::thread thread(std::move(work));
    Raised interrupt;
    try {
        interrupt =
            wait_until([&] { return end.wait_for(milliseconds(50)) == std::future_status::ready; });
    } catch (const py::error_already_set&) {
        thread.detach();
        throw;
    }
    unlocked([&] { thread.join(); });
    return finishes(interrupt, callback, [&] { return end.get(); });
}

bool PythonRenderer::run(const py::object& report) {
    return renders(report, [](Renderer& renderer, const Renderer::Report& reported) {
        return renderer.run(reported);
    });
}

bool PythonRenderer::step(std::uint32_t passes, const py::object& report) {
    return renders(report, [passes](Renderer& renderer, const Renderer::Report& reported) {
        return renderer.step(passes, reported);
    });
}

void PythonRenderer::start(const py::object& report) {
    const LockClaim claim;
    if (!claim) return;
    const SharedCallback callback = callback_of(report);
    renderer_->start(reporter(callback));
    report_ = callback;
    is_started_ = true;
}

bool PythonRenderer::wait() {
    const LockClaim claim;
    if (!claim) return false;
    const bool is_in_callback =
        log_->is_called_on_this_thread() || (report_ && report_->is_called_on_this_thread());
    if (!is_started_ || is_in_callback) return renderer_->wait() == Outcome::finished;  // an Error
    if (is_awaited_)
        throw Error({"Renderer"}, "another thread waits for the render", "wait() on one thread");
    Raised interrupt;
    is_awaited_ = true;
    try {
        interrupt = wait_until([&] {
            std::this_thread::sleep_for(milliseconds(2));
            return !renderer_->is_running();
        });
    } catch (const py::error_already_set&) {
        is_awaited_ = false;
        throw;
    }
    is_awaited_ = is_started_ = false;
    return finishes(interrupt, std::exchange(report_, nullptr),
                    [&] { return unlocked([&] { return renderer_->wait(); }); });
}

}  // namespace sunfleck::python
