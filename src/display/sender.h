// DisplaySender: shows pictures in tev, on a thread of its own.
//
// In:  pictures, of which the latest is kept. Out: packets on a connection. Whoever shows a picture
// never waits. A receiver that goes, or takes nothing for a while, is given up with one warning.
#pragma once

#include "display/connection.h"
#include "image/picture.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace sunfleck::engine {

struct SenderSettings {
    DisplayAddress address;
    std::string flag;                               // by which the user has asked for it
    std::string image;                              // the name under which tev lists it
    std::function<void(const std::string&)> warn;   // called by the sender's thread, or finish()
    std::chrono::milliseconds patience{5000};       // with a receiver that takes nothing
    std::chrono::milliseconds most_at_end{10'000};  // for the last picture
};

class DisplaySender {
public:
    /// Connects. @throws Error if nobody listens at the address.
    explicit DisplaySender(SenderSettings settings);
    /// Sends no more.
    ~DisplaySender();
    DisplaySender(const DisplaySender&) = delete;
    DisplaySender& operator=(const DisplaySender&) = delete;
    DisplaySender(DisplaySender&&) = delete;
    DisplaySender& operator=(DisplaySender&&) = delete;

    /// Shows a picture when the one before has been sent, unless a later one comes first. An image
    /// of other channels or another size is made anew.
    void show(Picture picture);
    /// Returns the processor time that the last picture took to send.
    std::chrono::nanoseconds cost() const;
    /// Returns whether the receiver has been given up.
    bool is_over() const;
    /// Waits until the last picture has been sent, as long as the settings allow.
    void finish();

private:
    void run();
    /// Waits for the next picture. @return none at the end.
    std::optional<Picture> next();
    /// @return whether all of it has been sent.
    bool send(const Picture& picture);
    void note_sent(std::chrono::nanoseconds cost);
    void give_up(const std::string& why);

    SenderSettings settings_;
    DisplayConnection connection_;
    Picture made_;  // of no pixels: size and channels of the image that tev has
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Picture> waiting_;
    std::chrono::nanoseconds cost_{};
    bool is_sending_ = false;
    bool is_over_ = false;
    std::atomic<bool> stop_ = false;
    std::thread thread_;
};

}  // namespace sunfleck::engine
