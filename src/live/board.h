// LiveBoard: the latest picture of a render and what is said of it, for viewers on other threads.
//
// The render puts them up and goes on; viewers take what is there. Neither waits for the other.
#pragma once

#include "image/picture.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace sunfleck::engine {

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

    /// Replaces the picture. @return its number, the next one.
    std::uint64_t show(Picture picture);
    /// Replaces the text.
    void tell(std::string text);
    /// Ends all waiting, now and later.
    void close();

    Shown shown() const;
    /// Returns the text if it is later than `seen`, waiting for one no longer than `most`.
    std::optional<Text> text_after(std::uint64_t seen, std::chrono::milliseconds most) const;
    bool is_closed() const;

private:
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    Shown shown_;
    Text text_;
    bool closed_ = false;
};

}  // namespace sunfleck::engine
