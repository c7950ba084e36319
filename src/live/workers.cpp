// A thread works as long as tasks wait, and goes.
#include "live/workers.h"

#include <thread>
#include <utility>

namespace sunfleck::engine {

void Workers::add(std::function<void()> task) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->waiting.push_back(std::move(task));
        if (state_->running == state_->most) return;
        ++state_->running;
    }
    std::thread([state = state_] { run(*state); }).detach();
}

void Workers::run(State& state) {
    std::unique_lock lock(state.mutex);
    while (!state.waiting.empty()) {
        const std::function<void()> task = std::move(state.waiting.front());
        state.waiting.pop_front();
        lock.unlock();
        task();
        lock.lock();
    }
    --state.running;
    state.ended.notify_all();
}

bool Workers::end(std::chrono::milliseconds most) {
    std::unique_lock lock(state_->mutex);
    state_->waiting.clear();
    return state_->ended.wait_for(lock, most, [&] { return state_->running == 0; });
}

}  // namespace sunfleck::engine
