// Renders that Python waits for, with the lock of the interpreter released.
#pragma once

#include "python/text.h"

#include <pybind11/pybind11.h>
#include <sunfleck/sunfleck.h>

#include <exception>
#include <memory>
#include <mutex>
#include <optional>

namespace sunfleck::python {

namespace py = pybind11;

/// A renderer whose callbacks are Python's: what they raise cancels the render and reaches the
/// caller, as Ctrl-C does.
class PythonRenderer {
public:
    /// @param log  called as log(severity, line); None: warnings become Python's.
    PythonRenderer(const Scene& scene, const Settings& settings, std::size_t threads,
                   const py::object& log);
    ~PythonRenderer();
    PythonRenderer(const PythonRenderer&) = delete;
    PythonRenderer& operator=(const PythonRenderer&) = delete;
    PythonRenderer(PythonRenderer&&) = delete;
    PythonRenderer& operator=(PythonRenderer&&) = delete;

    bool run(const py::object& report);
    bool step(std::uint32_t passes, const py::object& report);
    void start(const py::object& report);
    /// @return whether it is finished, and not cancelled.
    bool wait();

    Renderer& renderer() { return *renderer_; }

private:
    Renderer::Report reporter(const py::object& report);
    void raise();
    template <class Task>
    bool finishes(const Task& task);

    std::unique_ptr<Renderer> renderer_;
    std::mutex guard_;
    std::exception_ptr raised_;  // by a callback
};

}  // namespace sunfleck::python
