// The lock of the interpreter, and the end of Python.
//
// Once Python ends, whoever asks for the lock is ended by force, and the process with it. Before,
// Python cancels all renders here, and waits for all threads that will ask for the lock.
#pragma once

#include "python/text.h"

#include <pybind11/pybind11.h>
#include <sunfleck/sunfleck.h>

#include <memory>
#include <optional>

namespace sunfleck::python {

namespace py = pybind11;

/// Stands for a thread that will ask for the lock: Python does not end before it has let go of it.
class Guest {
public:
    Guest();
    ~Guest();
    Guest(const Guest&) = delete;
    Guest& operator=(const Guest&) = delete;
    Guest(Guest&&) = delete;
    Guest& operator=(Guest&&) = delete;

    /// False if Python ends: the thread must not ask for the lock, or not let go of it.
    explicit operator bool() const { return is_welcome_; }

private:
    bool is_welcome_;
};

/// Runs task() with the lock released; at the end of Python with the lock held.
template <class Task>
auto unlocked(const Task& task) {
    const Guest guest;
    std::optional<py::gil_scoped_release> released;
    if (guest) released.emplace();
    return task();
}

/// The end of Python cancels this renderer.
void end_with_python(const std::shared_ptr<Renderer>& renderer);

/// Has Python call what this file promises for its end.
void add_end();

}  // namespace sunfleck::python
