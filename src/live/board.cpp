// One lock for all; pictures are shared, not copied.
#include "live/board.h"

#include <utility>

namespace sunfleck::engine {

std::uint64_t LiveBoard::show(Picture picture) {
    auto shared = std::make_shared<const Picture>(std::move(picture));
    const std::lock_guard lock(mutex_);
    std::swap(shown_.picture, shared);  // the last one goes after the lock, if nobody reads it
    return ++shown_.number;
}

void LiveBoard::tell(std::string text) {
    {
        const std::lock_guard lock(mutex_);
        text_.text = std::move(text);
        ++text_.number;
        text_.told = Clock::now();
    }
    changed_.notify_all();
}

void LiveBoard::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

LiveBoard::Shown LiveBoard::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

std::optional<LiveBoard::Text> LiveBoard::text_after(std::uint64_t seen,
                                                     std::chrono::milliseconds most) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, most, [&] { return closed_ || text_.number > seen; });
    if (text_.number > seen) return text_;
    return {};
}

bool LiveBoard::is_closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
}

}  // namespace sunfleck::engine
