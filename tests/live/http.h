// A client of HTTP/1.1 that can be as rude as a test wants: bytes over a socket.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace sunfleck::engine::testing_support {

/// A connection to a port of 127.0.0.1.
class Connection {
public:
    explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        ::sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): as connect(2) has it
        is_open_ = ::connect(socket_, reinterpret_cast<::sockaddr*>(&address), sizeof address) == 0;
        const ::timeval patience{20, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~Connection() { ::close(socket_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    Connection(Connection&&) = delete;
    Connection& operator=(Connection&&) = delete;

    bool is_open() const { return is_open_; }
    void send(const std::string& bytes) const {
        ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }
    /// Says that nothing more will be sent.
    void finish() const { ::shutdown(socket_, SHUT_WR); }
    /// Returns what comes next, at most so much; nothing at the end.
    std::string receive(std::size_t most = 1U << 16U) const {
        std::string bytes(most, '\0');
        const ::ssize_t count = ::recv(socket_, bytes.data(), most, 0);
        bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return bytes;
    }
    /// Returns all up to the end, or to this mark.
    std::string receive_until(const std::string& mark = "") const {
        std::string all;
        for (std::string more = receive(); !more.empty(); more = receive()) {
            all += more;
            if (!mark.empty() && all.find(mark) != std::string::npos) break;
        }
        return all;
    }

private:
    int socket_;
    bool is_open_ = false;
};

/// The parts of http://127.0.0.1:PORT/?token=TOKEN
struct Address {
    int port = 0;
    std::string token;

    explicit Address(const std::string& url) {
        const std::size_t colon = url.rfind(':');
        const std::size_t mark = url.rfind("/?token=");
        if (!url.starts_with("http://127.0.0.1:") || mark == std::string::npos) return;
        port = std::stoi(url.substr(colon + 1, mark - colon - 1));
        token = url.substr(mark + 8);
    }
};

/// Returns a request of one connection. @param more  lines of its head.
inline std::string request(const std::string& method, const std::string& path,
                           const std::string& host = "127.0.0.1", const std::string& more = "") {
    return method + " " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n" + more +
           "\r\n";
}

/// Returns head and body of the answer.
inline std::string ask(int port, const std::string& bytes) {
    const Connection connection(port);
    connection.send(bytes);
    return connection.receive_until();
}

inline int status_of(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
}

inline std::string body_of(const std::string& answer) {
    const std::size_t end = answer.find("\r\n\r\n");
    return end == std::string::npos ? "" : answer.substr(end + 4);
}

}  // namespace sunfleck::engine::testing_support
