// The thread takes the latest picture, and sends it block by block.
#include "display/sender.h"

#include "display/packets.h"

#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the processor time of this thread so far.
std::chrono::nanoseconds thread_time() {
    ::timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Returns size and channels of a picture, as one of no pixels.
Picture outline_of(const Picture& picture) {
    Picture outline{picture.width, picture.height, {}, {}};
    for (const Channel& channel : picture.channels) outline.channels.push_back({channel.name, {}});
    return outline;
}

}  // namespace

DisplaySender::DisplaySender(SenderSettings settings)
    : settings_(std::move(settings)),
      connection_(settings_.address, settings_.flag),
      thread_([this] { run(); }) {}

DisplaySender::~DisplaySender() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void DisplaySender::show(Picture picture) {
    {
        const std::lock_guard lock(mutex_);
        if (is_over_) return;
        waiting_ = std::move(picture);
    }
    changed_.notify_all();
}

std::chrono::nanoseconds DisplaySender::cost() const {
    const std::lock_guard lock(mutex_);
    return cost_;
}

bool DisplaySender::is_over() const {
    const std::lock_guard lock(mutex_);
    return is_over_;
}

void DisplaySender::finish() {
    std::unique_lock lock(mutex_);
    const bool is_sent = changed_.wait_for(
        lock, settings_.most_at_end, [this] { return is_over_ || (!waiting_ && !is_sending_); });
    if (is_sent) return;
    is_over_ = true;
    lock.unlock();
    settings_.warn(fmt::format("{} {}: the last picture has not been taken in {:.1f} s",
                               settings_.flag, settings_.address.text,
                               std::chrono::duration<double>(settings_.most_at_end).count()));
}

void DisplaySender::run() {
    try {
        while (const std::optional<Picture> picture = next()) {
            const std::chrono::nanoseconds before = thread_time();
            if (!send(*picture)) return;
            note_sent(thread_time() - before);
        }
    } catch (const std::exception& fault) {
        give_up(fault.what());
    }
}

std::optional<Picture> DisplaySender::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stop_ || waiting_; });
    if (stop_) return std::nullopt;
    is_sending_ = true;
    return std::exchange(waiting_, std::nullopt);
}

bool DisplaySender::send(const Picture& picture) {
    const auto send_all = [this](const std::string& packet) {
        return connection_.send(packet, settings_.patience, stop_) == DisplayConnection::Sent::all;
    };
    if (Picture outline = outline_of(picture); outline != made_) {
        const bool is_first = made_.channels.empty();
        if (!send_all(create_packet(settings_.image, picture, is_first))) return false;
        made_ = std::move(outline);
    }
    for (const DisplayBlock& block : blocks_of(picture))
        if (!send_all(update_packet(settings_.image, picture, block))) return false;
    return true;
}

void DisplaySender::note_sent(std::chrono::nanoseconds cost) {
    {
        const std::lock_guard lock(mutex_);
        is_sending_ = false;
        cost_ = cost;
    }
    changed_.notify_all();
}

void DisplaySender::give_up(const std::string& why) {
    bool is_told = false;
    {
        const std::lock_guard lock(mutex_);
        is_told = std::exchange(is_over_, true);
        waiting_.reset();
    }
    changed_.notify_all();
    if (!is_told)
        settings_.warn(fmt::format("{} {}: {}; nothing more is sent to it", settings_.flag,
                                   settings_.address.text, why));
}

}  // namespace sunfleck::engine
