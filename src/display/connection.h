// A TCP connection to a display server, by which bytes are sent and none received.
#pragma once

#include "display/address.h"

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>

namespace sunfleck::engine {

class DisplayConnection {
public:
    /// Connects to the first of the host's addresses that answers.
    /// @throws Error if there is no such host, or nobody listens there.
    explicit DisplayConnection(const DisplayAddress& address, const std::string& flag);
    /// What has been sent still arrives.
    ~DisplayConnection();
    DisplayConnection(const DisplayConnection&) = delete;
    DisplayConnection& operator=(const DisplayConnection&) = delete;
    DisplayConnection(DisplayConnection&&) = delete;
    DisplayConnection& operator=(DisplayConnection&&) = delete;

    enum class Sent { all, stopped };
    /// Sends all bytes, unless `stop` becomes true meanwhile.
    /// @param patience  how long the receiver may take none of them.
    /// @throws std::runtime_error if it takes none for so long, or has gone.
    Sent send(std::string_view bytes, std::chrono::milliseconds patience,
              const std::atomic<bool>& stop) const;

private:
    int socket_ = -1;
};

}  // namespace sunfleck::engine
