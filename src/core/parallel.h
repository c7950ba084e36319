// Parallel loops with deterministic results; the only module that uses the thread library.
//
// In:  a count of independent tasks. Out: their effects.
// Rules: a task writes only to data of its own index, or adds integers (AtomicFixedPoint,
// std::atomic counts). Every thread flushes denormals alike.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace sunfleck::engine {

/// Limits later work to `count` threads while it lives, even where there are fewer cores. 0 means
/// as many threads as cores. The main thread creates it, outside of loops. Nested limits end in
/// reverse order; an inner one can only lower the number.
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

/// Threads of a library's caller: loops of what run() is given use no others. Thread-safe; several
/// pools do not limit each other.
class ThreadPool {
public:
    /// @param count  of threads, at most, and no more than cores; 0: as many as cores.
    explicit ThreadPool(std::size_t count);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ThreadPool(ThreadPool&&) = delete;
    ThreadPool& operator=(ThreadPool&&) = delete;

    /// Runs task() with the default floating-point modes, whatever those of the caller are.
    void run(const std::function<void()>& task);

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

/// Returns the number of threads that parallel_for() may use now.
std::size_t thread_count();

/// Calls task(i) once for each i in [0, count), on any thread, in any order. The first exception
/// reaches the caller. A task should take at least some microseconds.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

/// Returns the block length that splits `count` indices into one block per thread.
/// @param least  lower bound of the result, so that small work is not split.
std::size_t block_of_a_thread(std::size_t count, std::size_t least);

/// Calls task(begin, end) for consecutive blocks that cover [0, count); the last may be shorter.
/// @param block  block length, at least 1.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& task);

/// Runs task() with cancellation: its loops, and loops nested in them, call is_over() before each
/// task, on any thread.
/// @param is_over  may be empty: no cancellation.
/// @return false if a loop was cancelled: then task() was abandoned, and its results are
/// incomplete.
bool run_unless(const std::function<bool()>& is_over, const std::function<void()>& task);

}  // namespace sunfleck::engine
