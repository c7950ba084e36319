// A count of claims, and what Python's atexit calls.
#include "python/interpreter.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

namespace sunfleck::python {
namespace {

struct Claims {
    std::mutex guard;
    int count = 0;
    bool is_closed = false;
    std::vector<std::weak_ptr<Renderer>> renderers;
};

/// Never destroyed: threads may be left when the process ends.
Claims& claims() {
    static auto* const all = new Claims;
    return *all;
}

/// From now on no claim is granted. @return the renderers that there are.
std::vector<std::shared_ptr<Renderer>> refuse_claims() {
    const std::lock_guard lock(claims().guard);
    claims().is_closed = true;
    std::vector<std::shared_ptr<Renderer>> renderers;
    for (const auto& renderer : claims().renderers)
        if (auto alive = renderer.lock()) renderers.push_back(std::move(alive));
    return renderers;
}

bool is_none_left() {
    const std::lock_guard lock(claims().guard);
    return claims().count == 0;
}

/// Waits until nobody asks for the lock. Ctrl-C ends the wait for a report that does not return.
void end() {
    const std::vector<std::shared_ptr<Renderer>> renderers = refuse_claims();
    const auto renders = [](const auto& renderer) { return renderer->is_running(); };
    while (!is_none_left() || std::any_of(renderers.begin(), renderers.end(), renders)) {
        for (const auto& renderer : renderers) renderer->cancel();
        {
            const py::gil_scoped_release released;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

}  // namespace

LockClaim::LockClaim() {
    const std::lock_guard lock(claims().guard);
    is_granted_ = !claims().is_closed;
    if (is_granted_) ++claims().count;
}

LockClaim::~LockClaim() {
    const std::lock_guard lock(claims().guard);
    if (is_granted_) --claims().count;
}

void end_with_python(const std::shared_ptr<Renderer>& renderer) {
    const std::lock_guard lock(claims().guard);
    std::erase_if(claims().renderers, [](const auto& other) { return other.expired(); });
    claims().renderers.push_back(renderer);
}

void add_end() {
    py::module_::import("atexit").attr("register")(py::cpp_function(end));
}

}  // namespace sunfleck::python
