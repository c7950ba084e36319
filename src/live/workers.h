// Workers: the threads of a server's connections, which do not keep the program from ending.
//
// A peer that sends a byte now and then may hold a thread of the library's own queue for hours, and
// that queue waits for all its threads.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace sunfleck::engine {

class Workers {
public:
    /// @param most  threads at a time; further tasks wait.
    explicit Workers(int most) : state_(std::make_shared<State>()) { state_->most = most; }

    void add(std::function<void()> task);
    /// Drops what waits, and waits for what runs. @return whether all of it has ended in time.
    bool end(std::chrono::milliseconds most);

private:
    struct State {
        std::mutex mutex;
        std::condition_variable ended;
        std::deque<std::function<void()>> waiting;
        int most = 0;
        int running = 0;
    };
    static void run(State& state);

    std::shared_ptr<State> state_;  // shared with threads that may outlive this
};

}  // namespace sunfleck::engine
