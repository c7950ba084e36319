// LiveBoard: the latest pictures of a render and what is said of it, for viewers on other threads.
//
// The render puts them up and goes on; viewers take what is there. Neither waits for the other.
#pragma once

#include "image/picture.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace sunfleck::engine {

/// Places for a picture each.
enum class LivePlace : std::size_t {
    render,   // what is rendered
    look,     // what a viewer looks at aside
    earlier,  // a finished picture to compare with
    count
};

class LiveBoard {
public:
    using Clock = std::chrono::steady_clock;

    struct Text {
        std::string text;
        std::uint64_t number = 0;  // of the text: each is one more than the one before
        Clock::time_point told{};
    };
    struct Shown {
        std::shared_ptr<const Picture> picture;  // null before the first
        std::uint64_t number = 0;                // of the picture; zero before the first
    };

    /// Replaces the picture of a place. @return its number: one more than that of the last picture
    /// anywhere.
    std::uint64_t show(Picture picture, LivePlace place = LivePlace::render);
    /// Takes the picture of a place away.
    void clear(LivePlace place);
    /// Replaces the text.
    void tell(std::string text);
    /// Ends all waiting, now and later.
    void close();

    Shown shown(LivePlace place = LivePlace::render) const;
    /// Returns the text if it is later than `seen`, waiting for one no longer than `most`.
    std::optional<Text> text_after(std::uint64_t seen, std::chrono::milliseconds most) const;
    bool is_closed() const;

private:
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::array<Shown, static_cast<std::size_t>(LivePlace::count)> shown_;
    std::uint64_t number_ = 0;  // of the last picture
    Text text_;
    bool closed_ = false;
};

}  // namespace sunfleck::engine
