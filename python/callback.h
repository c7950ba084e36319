// Functions of Python that the library calls, on threads of its own.
#pragma once

#include "python/interpreter.h"

#include <initializer_list>
#include <memory>
#include <optional>
#include <thread>

namespace sunfleck::python {

/// What Python has raised, or nothing.
using Raised = std::optional<py::error_already_set>;

/// Throws the first that there is; the others are its context.
void raise_first(std::initializer_list<Raised> all);

/// What the function raises is kept for the call that renders; where none takes it, Python prints
/// it in the end. All but the destructor and operator() needs the lock of the interpreter.
class Callback {
public:
    /// @throws py::type_error  for what cannot be called.
    explicit Callback(py::object function);
    ~Callback();
    Callback(const Callback&) = delete;
    Callback& operator=(const Callback&) = delete;
    Callback(Callback&&) = delete;
    Callback& operator=(Callback&&) = delete;

    /// Calls the function, unless it has raised or Python ends.
    /// @return false once it has raised: the render is to end.
    template <class... Arguments>
    bool operator()(const Arguments&... arguments);

    bool is_called_on_this_thread() const { return caller_ == std::this_thread::get_id(); }
    Raised take() { return std::exchange(raised_, std::nullopt); }

private:
    py::object function_;
    Raised raised_;
    std::thread::id caller_;
};

template <class... Arguments>
bool Callback::operator()(const Arguments&... arguments) {
    const LockClaim claim;
    if (!claim) return true;
    const py::gil_scoped_acquire lock;
    if (raised_) return false;
    caller_ = std::this_thread::get_id();
    try {
        function_(arguments...);
    } catch (const py::error_already_set& fault) {
        raised_ = fault;
    }
    caller_ = {};
    return !raised_;
}

}  // namespace sunfleck::python
