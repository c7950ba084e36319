// A count of guests, and what Python's atexit calls.
#include "python/interpreter.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

namespace sunfleck::python {
namespace {

struct House {
    std::mutex guard;
    int guests = 0;
    bool is_closed = false;
    std::vector<std::weak_ptr<Renderer>> renderers;
};

/// Never destroyed: threads may be left when the process ends.
House& house() {
    static auto* const all = new House;
    return *all;
}

std::vector<std::shared_ptr<Renderer>> close_house() {
    const std::lock_guard lock(house().guard);
    house().is_closed = true;
    std::vector<std::shared_ptr<Renderer>> renderers;
    for (const auto& renderer : house().renderers)
        if (auto alive = renderer.lock()) renderers.push_back(std::move(alive));
    return renderers;
}

bool is_empty() {
    const std::lock_guard lock(house().guard);
    return house().guests == 0;
}

/// Ctrl-C ends the wait for a report that does not return.
void end() {
    const std::vector<std::shared_ptr<Renderer>> renderers = close_house();
    const auto renders = [](const auto& renderer) { return renderer->is_running(); };
    while (!is_empty() || std::any_of(renderers.begin(), renderers.end(), renders)) {
        for (const auto& renderer : renderers) renderer->cancel();
        {
            const py::gil_scoped_release released;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

}  // namespace

Guest::Guest() {
    const std::lock_guard lock(house().guard);
    is_welcome_ = !house().is_closed;
    if (is_welcome_) ++house().guests;
}

Guest::~Guest() {
    const std::lock_guard lock(house().guard);
    if (is_welcome_) --house().guests;
}

void end_with_python(const std::shared_ptr<Renderer>& renderer) {
    const std::lock_guard lock(house().guard);
    std::erase_if(house().renderers, [](const auto& other) { return other.expired(); });
    house().renderers.push_back(renderer);
}

void add_end() {
    py::module_::import("atexit").attr("register")(py::cpp_function(end));
}

}  // namespace sunfleck::python
