// One lock for all; pictures are shared, not copied.
#include "live/board.h"

#include <utility>

namespace sunfleck::engine {

std::uint64_t LiveBoard::show(Picture picture, LivePlace place) {
    auto shared = std::make_shared<const Picture>(std::move(picture));
    const std::lock_guard lock(mutex_);
    Shown& shown = shown_.at(static_cast<std::size_t>(place));
    std::swap(shown.picture, shared);  // the last one goes after the lock, if nobody reads it
    return shown.number = ++number_;
}

void LiveBoard::clear(LivePlace place) {
    Shown empty;
    const std::lock_guard lock(mutex_);
    std::swap(shown_.at(static_cast<std::size_t>(place)), empty);
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

LiveBoard::Shown LiveBoard::shown(LivePlace place) const {
    const std::lock_guard lock(mutex_);
    return shown_.at(static_cast<std::size_t>(place));
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
