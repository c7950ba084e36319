// A receiver of tev's protocol, written from its description: it reads packets byte by byte.
#pragma once

#include "image/picture.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck::engine::testing_support {

/// A port of this machine at which one sender may call.
class Receiver {
public:
    /// @param buffer  bytes that the system takes before anybody reads; 0: as many as it likes.
    explicit Receiver(int family = AF_INET, int buffer = 0)
        : listening_(::socket(family, SOCK_STREAM, 0)) {
        if (buffer > 0) ::setsockopt(listening_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
        ::sockaddr_storage any{};
        any.ss_family = static_cast<::sa_family_t>(family);
        if (family == AF_INET)
            as<::sockaddr_in>(any).sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        else
            as<::sockaddr_in6>(any).sin6_addr = in6addr_loopback;
        ::socklen_t size = family == AF_INET ? sizeof(::sockaddr_in) : sizeof(::sockaddr_in6);
        is_open_ = ::bind(listening_, &as<::sockaddr>(any), size) == 0 &&
                   ::listen(listening_, 4) == 0 &&
                   ::getsockname(listening_, &as<::sockaddr>(any), &size) == 0;
        port_ = ntohs(family == AF_INET ? as<::sockaddr_in>(any).sin_port
                                        : as<::sockaddr_in6>(any).sin6_port);
        const ::timeval patience{60, 0};
        ::setsockopt(listening_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~Receiver() { close(); }
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;
    Receiver(Receiver&&) = delete;
    Receiver& operator=(Receiver&&) = delete;

    bool is_open() const { return is_open_; }
    std::string port() const { return std::to_string(port_); }
    /// Waits for the sender. @return whether it has come.
    bool accept() {
        peer_ = ::accept(listening_, nullptr, nullptr);
        const ::timeval patience{60, 0};
        ::setsockopt(peer_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        return peer_ >= 0;
    }
    /// Returns what comes next; nothing at the end.
    std::string receive() const {
        std::string bytes(1U << 16U, '\0');
        const ::ssize_t count = ::recv(peer_, bytes.data(), bytes.size(), 0);
        bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return bytes;
    }
    std::string receive_all() const {
        std::string all;
        for (std::string more = receive(); !more.empty(); more = receive()) all += more;
        return all;
    }
    void close() {
        for (int* socket : {&peer_, &listening_}) {
            if (*socket >= 0) ::close(*socket);
            *socket = -1;
        }
    }

private:
    template <class Address>
    static Address& as(::sockaddr_storage& any) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): as bind(2) has it
        return reinterpret_cast<Address&>(any);
    }

    int listening_;
    int peer_ = -1;
    int port_ = 0;
    bool is_open_ = false;
};

/// Reads the fields of a packet.
class Fields {
public:
    explicit Fields(const std::string& bytes) : bytes_(bytes) {}

    std::uint64_t number(std::size_t size) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value |= std::uint64_t{static_cast<unsigned char>(bytes_.at(at_ + i))} << (8 * i);
        at_ += size;
        return value;
    }
    int whole() { return static_cast<int>(number(4)); }
    std::string text() {
        std::string found;
        for (; bytes_.at(at_) != '\0'; ++at_) found += bytes_[at_];
        ++at_;
        return found;
    }
    float value(std::size_t index) const {
        Fields from(*this);
        from.at_ += 4 * index;
        return std::bit_cast<float>(static_cast<std::uint32_t>(from.number(4)));
    }
    std::size_t left() const { return bytes_.size() - at_; }

private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

/// What tev would list: images by name, and what came in which order.
struct Images {
    std::map<std::string, Picture> by_name;
    std::vector<std::string> created;        // names, one for each time
    std::vector<std::pair<int, int>> sizes;  // beside created
    std::vector<bool> selects;               // beside created
    std::vector<std::string> updated;        // first channel of each update
    std::size_t longest_packet = 0;          // in bytes
    std::size_t left = 0;                    // bytes of a packet that is cut off
};

inline void read_create(Fields fields, Images& images) {
    const bool selects = fields.number(1) != 0;
    const std::string name = fields.text();
    Picture picture{fields.whole(), 0, {}, {}};
    picture.height = fields.whole();
    const int channels = fields.whole();
    for (int i = 0; i < channels; ++i) picture.add(fields.text());
    if (fields.left() != 0) throw std::runtime_error("a create packet is too long");
    images.created.push_back(name);
    images.selects.push_back(selects);
    images.sizes.emplace_back(picture.width, picture.height);
    images.by_name[name] = std::move(picture);
}

inline void read_update(Fields fields, Images& images) {
    if (fields.number(1) != 0) throw std::runtime_error("an update selects the image");
    Picture& picture = images.by_name.at(fields.text());
    std::vector<std::string> names(static_cast<std::size_t>(fields.whole()));
    for (std::string& name : names) name = fields.text();
    const int x = fields.whole();
    const int y = fields.whole();
    const int width = fields.whole();
    const int height = fields.whole();
    std::vector<std::uint64_t> offsets(names.size());
    std::vector<std::uint64_t> strides(names.size());
    for (std::uint64_t& offset : offsets) offset = fields.number(8);
    for (std::uint64_t& stride : strides) stride = fields.number(8);
    images.updated.push_back(names.at(0));
    if (x < 0 || y < 0 || x + width > picture.width || y + height > picture.height)
        throw std::runtime_error("an update is not within the image");
    std::size_t floats = 0;
    for (std::size_t c = 0; c < names.size(); ++c) {
        Channel* channel = nullptr;
        for (Channel& one : picture.channels)
            if (one.name == names[c]) channel = &one;
        if (channel == nullptr) throw std::runtime_error("no channel " + names[c]);
        for (int i = 0; i < width * height; ++i) {
            const std::size_t from = offsets[c] + static_cast<std::size_t>(i) * strides[c];
            const int to = (y + i / width) * picture.width + x + i % width;
            channel->values.at(static_cast<std::size_t>(to)) = fields.value(from);
            floats = std::max(floats, from + 1);
        }
    }
    if (fields.left() != 4 * floats) throw std::runtime_error("an update has other bytes, too");
}

/// Returns the images that the bytes of a connection make, or their first packets.
/// @throws std::exception for a fault.
inline Images read_images(const std::string& bytes, int packets = 1'000'000) {
    Images images;
    std::size_t at = 0;
    for (; packets > 0 && bytes.size() - at >= 4; --packets) {
        const std::size_t size = Fields(bytes.substr(at, 4)).number(4);
        if (size < 5) throw std::runtime_error("a packet is too short");
        if (bytes.size() - at < size) break;
        const std::string packet = bytes.substr(at, size);
        images.longest_packet = std::max(images.longest_packet, size);
        at += size;
        Fields fields(packet);
        fields.number(4);
        const std::uint64_t kind = fields.number(1);
        if (kind == 4)
            read_create(fields, images);
        else if (kind == 6)
            read_update(fields, images);
        else
            throw std::runtime_error("a packet of another kind");
    }
    images.left = bytes.size() - at;
    return images;
}

}  // namespace sunfleck::engine::testing_support
