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

/// A thread's claim to ask for the lock: Python does not end while there is one.
class LockClaim {
public:
    LockClaim();
    ~LockClaim();
    LockClaim(const LockClaim&) = delete;
    LockClaim& operator=(const LockClaim&) = delete;
    LockClaim(LockClaim&&) = delete;
    LockClaim& operator=(LockClaim&&) = delete;

    /// False once Python ends: the thread must not ask for the lock, or must not release it.
    explicit operator bool() const { return is_granted_; }

private:
    bool is_granted_;
};

/// Runs task() with the lock released; at the end of Python with the lock held.
template <class Task>
auto unlocked(const Task& task) {
    const LockClaim claim;
    std::optional<py::gil_scoped_release> released;
    if (claim) released.emplace();
    return task();
}

/// The end of Python cancels this renderer.
void end_with_python(const std::shared_ptr<Renderer>& renderer);

/// Lets the end of Python do what the head of this file says.
void add_end();

}  // namespace sunfleck::python
