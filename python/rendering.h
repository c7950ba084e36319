// Renders that Python waits for, with the lock of the interpreter released.
#pragma once

#include "python/callback.h"

#include <memory>

namespace sunfleck::python {

/// A renderer whose callbacks are Python's: what they raise cancels the render and reaches the
/// caller, as Ctrl-C does. The end of Python cancels it, too; later renders are cancelled at once.
class PythonRenderer {
public:
    /// @param log  called as log(severity, line).
    PythonRenderer(const Scene& scene, const Settings& settings, std::size_t threads,
                   const py::object& log);
    ~PythonRenderer();
    PythonRenderer(const PythonRenderer&) = delete;
    PythonRenderer& operator=(const PythonRenderer&) = delete;
    PythonRenderer(PythonRenderer&&) = delete;
    PythonRenderer& operator=(PythonRenderer&&) = delete;

    /// @return whether it is finished, and not cancelled; as step() and wait().
    bool run(const py::object& report);
    bool step(std::uint32_t passes, const py::object& report);
    void start(const py::object& report);
    bool wait();

    /// Calls change(Renderer&), which may log.
    template <class Change>
    void change(const Change& change) {
        unlocked([&] { change(*renderer_); });
        raise_first({log_->take()});
    }

    Renderer& renderer() { return *renderer_; }

private:
    using SharedCallback = std::shared_ptr<Callback>;  // empty: nobody is told

    Renderer::Report reporter(const SharedCallback& report) const;
    template <class Done>
    Raised wait_until(const Done& is_done);
    template <class Result>
    bool finishes(const Raised& interrupt, const SharedCallback& report, const Result& result);
    template <class Task>
    bool renders(const py::object& report, const Task& task);

    SharedCallback log_;
    std::shared_ptr<Renderer> renderer_;
    SharedCallback report_;    // of start()
    bool is_started_ = false;  // until wait() has returned
    bool is_awaited_ = false;
};

}  // namespace sunfleck::python
