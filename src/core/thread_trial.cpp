// Threads that wait for the last of them.
#include "core/thread_trial.h"

#include "core/machine_fault.h"
#include "core/parallel.h"

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sunfleck::engine {
namespace {

/// Threads that end when it does.
class Waiting {
public:
    Waiting() = default;
    ~Waiting() {
        {
            const std::lock_guard lock(guard_);
            over_ = true;
        }
        end_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    Waiting(Waiting&&) = delete;
    Waiting& operator=(Waiting&&) = delete;

    void start() {
        threads_.emplace_back([this] {
            std::unique_lock lock(guard_);
            end_.wait(lock, [this] { return over_; });
        });
    }
    std::size_t count() const { return threads_.size(); }

private:
    std::mutex guard_;
    std::condition_variable end_;
    bool over_ = false;
    std::vector<std::thread> threads_;
};

/// @param count  threads beside the caller's.
void start_and_end(std::size_t count) {
    Waiting waiting;
    try {
        while (waiting.count() < count) waiting.start();
    } catch (const std::system_error& fault) {
        const std::string had = std::to_string(waiting.count() + 1);
        throw MachineFault(
            {"--nthreads"},
            std::to_string(count + 1) + " threads are asked for, and the machine gives " + had +
                ": " + fault.code().message(),
            "use --nthreads " + had + ", or raise the limit of processes (ulimit -u)");
    }
}

}  // namespace

void try_threads() {
    start_and_end(thread_count() - 1);
    // Else it would begin within Embree, and where it has no memory then, wait for itself forever.
    parallel_for(2, [](std::size_t) {});
}

}  // namespace sunfleck::engine
