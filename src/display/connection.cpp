// Sockets that do not block.
#include "display/connection.h"

#include "sunfleck/error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace sunfleck::engine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAnswerTime(5000);  // of a host that is far away
constexpr std::chrono::milliseconds kTick(50);          // between two looks at `stop`
constexpr int kHeldBack = 1 << 18;  // bytes on their way: so it is soon seen that none are taken

using Addresses = std::unique_ptr<::addrinfo, decltype(&::freeaddrinfo)>;

std::string text_of_errno(int fault) {
    return std::generic_category().message(fault);
}

Addresses addresses_of(const DisplayAddress& address, const std::string& flag) {
    ::addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    ::addrinfo* found = nullptr;
    const int fault = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found);
    if (fault != 0)
        throw Error({flag},
                    fmt::format("the host \"{}\" cannot be found ({})", address.host,
                                fault == EAI_SYSTEM ? text_of_errno(errno) : ::gai_strerror(fault)),
                    "name the machine on which tev runs");
    return {found, ::freeaddrinfo};
}

/// Waits until more can be sent. @return whether that is so.
bool wait_for_room(int socket, std::chrono::milliseconds most) {
    ::pollfd waiting{socket, POLLOUT, 0};
    int count = -1;
    do count = ::poll(&waiting, 1, static_cast<int>(most.count()));
    while (count < 0 && errno == EINTR);
    return count > 0;
}

/// Returns zero, or the errno for which it does not connect.
int connect_fault(int socket, const ::addrinfo& address) {
    if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
    if (errno != EINPROGRESS && errno != EINTR) return errno;
    if (!wait_for_room(socket, kAnswerTime)) return ETIMEDOUT;
    int fault = 0;
    ::socklen_t size = sizeof fault;
    return ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

}  // namespace

DisplayConnection::DisplayConnection(const DisplayAddress& address, const std::string& flag) {
    const Addresses all = addresses_of(address, flag);
    int fault = 0;
    for (const ::addrinfo* one = all.get(); one != nullptr; one = one->ai_next) {
        socket_ = ::socket(one->ai_family, one->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                           one->ai_protocol);
        fault = socket_ < 0 ? errno : connect_fault(socket_, *one);
        if (fault == 0) break;
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }
    if (socket_ < 0)
        throw Error({flag},
                    fmt::format("nobody listens at {} ({})", address.text, text_of_errno(fault)),
                    "start tev first, or name the address where it listens");
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDBUF, &kHeldBack, sizeof kHeldBack);
}

DisplayConnection::~DisplayConnection() {
    ::close(socket_);
}

DisplayConnection::Sent DisplayConnection::send(std::string_view bytes,
                                                std::chrono::milliseconds patience,
                                                const std::atomic<bool>& stop) const {
    Clock::time_point taken = Clock::now();
    while (!bytes.empty()) {
        if (stop) return Sent::stopped;
        const ::ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
            taken = Clock::now();
            continue;
        }
        if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
            throw std::runtime_error(fmt::format("it has gone ({})", text_of_errno(errno)));
        if (Clock::now() - taken > patience)
            throw std::runtime_error(fmt::format("it has taken nothing for {:.1f} s",
                                                 std::chrono::duration<double>(patience).count()));
        wait_for_room(socket_, kTick);
    }
    return Sent::all;
}

}  // namespace sunfleck::engine
