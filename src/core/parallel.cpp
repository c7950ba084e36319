// Parallel loops on TBB; the only file that includes it.
#include "core/parallel.h"

#include "core/default_floats.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <utility>

#if defined(__SANITIZE_THREAD__)
#include <future>
#include <vector>
#endif
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace sunfleck::engine {
namespace {

/// Flushes denormals to zero, and reads them as zero, while it lives; alike on every thread.
class FlushDenormals {
public:
#if defined(__SSE__)
    FlushDenormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | 0x8040U);
    }
    ~FlushDenormals() {
        _mm_setcsr(before_);
    }
#else
    FlushDenormals() = default;
    ~FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
    FlushDenormals(FlushDenormals&&) = delete;
    FlushDenormals& operator=(FlushDenormals&&) = delete;

private:
    unsigned before_ = 0;
};

using IsOver = std::function<bool()>;

/// The cancellation test of the loops of this thread.
thread_local const IsOver* asked = nullptr;

/// Sets the cancellation test while it lives.
class Asking {
public:
    explicit Asking(const IsOver* is_over) : before_(std::exchange(asked, is_over)) {}
    ~Asking() { asked = before_; }
    Asking(const Asking&) = delete;
    Asking& operator=(const Asking&) = delete;
    Asking(Asking&&) = delete;
    Asking& operator=(Asking&&) = delete;

private:
    const IsOver* before_;
};

/// Thrown by a cancelled loop; run_unless() catches it.
struct LoopIsOver {};

/// The arena of the innermost ThreadLimit; null without one.
std::atomic<tbb::task_arena*> limited_arena{nullptr};

}  // namespace

/// The control bounds the threads of all libraries that share TBB (also Embree's builds). The arena
/// gives loops that many threads even where there are fewer cores.
struct ThreadLimit::Control {
    explicit Control(std::size_t count)
        : control(tbb::global_control::max_allowed_parallelism, count),
          arena(static_cast<int>(count)),
          outer(limited_arena.exchange(&arena)) {}
    ~Control() { limited_arena = outer; }
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;
    Control(Control&&) = delete;
    Control& operator=(Control&&) = delete;

    tbb::global_control control;
    tbb::task_arena arena;
    tbb::task_arena* outer;
};

ThreadLimit::ThreadLimit(std::size_t count)
    : control_(count == 0 ? nullptr : std::make_unique<Control>(count)) {}

ThreadLimit::~ThreadLimit() = default;

struct ThreadPool::Arena {
    explicit Arena(std::size_t count)
        : arena(count == 0 ? tbb::task_arena::automatic : at_most_cores(count)) {}
    /// TBB warns on standard error of more.
    static int at_most_cores(std::size_t count) {
        const int cores = tbb::info::default_concurrency();
        return count < static_cast<std::size_t>(cores) ? static_cast<int>(count) : cores;
    }
    tbb::task_arena arena;
};

ThreadPool::ThreadPool(std::size_t count) : arena_(std::make_unique<Arena>(count)) {}

ThreadPool::~ThreadPool() = default;

void ThreadPool::run(const std::function<void()>& task) {
    arena_->arena.execute([&] {
        const DefaultFloats modes;
        task();
    });
}

std::size_t thread_count() {
    const auto limit =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::task_arena* arena = limited_arena;
    const int threads =
        arena != nullptr ? arena->max_concurrency() : tbb::this_task_arena::max_concurrency();
    return std::min(limit, static_cast<std::size_t>(threads));
}

namespace {

#if defined(__SANITIZE_THREAD__)
/// TBB is not built for the thread sanitizer, which would report races inside it. In such a build
/// plain threads run the loops, so that races between tasks are found.
template <class Task>
void run_loop(std::size_t count, const Task& task) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < std::min(count, thread_count()); ++i)
        others.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& other : others) other.get();
}
#else
template <class Task>
void run_loop(std::size_t count, const Task& task) {
    const auto loop = [&] { tbb::parallel_for(std::size_t{0}, count, task); };
    if (tbb::task_arena* arena = limited_arena)
        arena->execute(loop);
    else
        loop();
}
#endif

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) {
    run_loop(count, [&, is_over = asked](std::size_t i) {
        const FlushDenormals flush;
        const Asking inherited(is_over);
        if (is_over != nullptr && (*is_over)()) throw LoopIsOver{};
        task(i);
    });
}

bool run_unless(const std::function<bool()>& is_over, const std::function<void()>& task) {
    const Asking asking(is_over ? &is_over : nullptr);
    try {
        task();
        return true;
    } catch (const LoopIsOver&) {
        return false;
    }
}

std::size_t block_of_a_thread(std::size_t count, std::size_t least) {
    const std::size_t threads = thread_count();
    return std::max(least, (count + threads - 1) / threads);
}

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& task) {
    parallel_for(count / block + (count % block != 0 ? 1 : 0),
                 [&](std::size_t i) { task(i * block, std::min(count, (i + 1) * block)); });
}

}  // namespace sunfleck::engine
