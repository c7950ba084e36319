// Work shared among threads without the result knowing it. The only door to the thread library.
//
// In:  a count of independent tasks. Out: their effects.
// Rules: a task writes only to places that belong to its own index, or adds integers
// (AtomicFixedPoint, std::atomic counts). Every thread flushes denormals alike.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace sunfleck::engine {

/// All later work runs on `count` threads, even where there are fewer cores, for as long as it
/// lives; 0 changes nothing: as many threads as cores. Made by the main thread, outside of loops;
/// the later ones end first, and an inner one only lowers the number.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t count);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;
    ThreadLimit(ThreadLimit&&) = delete;
    ThreadLimit& operator=(ThreadLimit&&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Threads that parallel_for may use now.
std::size_t thread_count();

/// Calls task(i) once for each i in [0, count), on any thread, in any order; the first exception
/// thrown reaches the caller. For tasks of at least some microseconds.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

/// How long blocks of `count` indices are so that each thread gets one. @param least  the result is
/// at least this, so that small work is not cut up.
std::size_t block_of_a_thread(std::size_t count, std::size_t least);

/// Calls task(begin, end) for consecutive blocks of `block` indices that cover [0, count); the last
/// may be shorter. @param block  at least 1.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& task);

/// Runs task(). Its loops, and loops within their tasks, ask before each task whether it is_over(),
/// on any thread. @param is_over  none: it never is. @return false if a loop was cut short: then
/// task() was left, and what it has written is of no use.
bool run_unless(const std::function<bool()>& is_over, const std::function<void()>& task);

}  // namespace sunfleck::engine
