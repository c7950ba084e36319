// One lock for all but what the render reads at each step.
#include "live/wishes.h"

namespace sunfleck::engine {

bool LiveWishes::set_look(const std::optional<Look>& look) {
    const std::lock_guard lock(mutex_);
    if (!is_accepting_) return false;
    const bool changes = look.has_value() || look_.has_value();
    look_ = look;
    if (changes) wants_change_ = true;
    return true;
}

bool LiveWishes::look(const Look& look) {
    return set_look(look);
}

bool LiveWishes::end_look() {
    return set_look({});
}

bool LiveWishes::pause(bool is_paused) {
    const std::lock_guard lock(mutex_);
    if (!is_accepting_) return false;
    is_paused_ = is_paused;
    return true;
}

bool LiveWishes::end_at(const LiveEnds& ends) {
    const std::lock_guard lock(mutex_);
    if (!is_accepting_) return false;
    ends_ = ends;
    return true;
}

void LiveWishes::accept() {
    const std::lock_guard lock(mutex_);
    is_accepting_ = true;
}

std::optional<Look> LiveWishes::take_look() {
    const std::lock_guard lock(mutex_);
    wants_change_ = false;
    return look_;
}

bool LiveWishes::wants_other_ends() const {
    const std::lock_guard lock(mutex_);
    return ends_.has_value();
}

std::optional<LiveEnds> LiveWishes::take_ends() {
    const std::lock_guard lock(mutex_);
    std::optional<LiveEnds> ends;
    ends.swap(ends_);
    return ends;
}

}  // namespace sunfleck::engine
