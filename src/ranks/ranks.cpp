// The binary tree over neighbours, up and down.
#include "ranks/ranks.h"

namespace sunfleck::engine {
namespace {

/// Does rank `r` take from rank r + step? It gives to r - step otherwise, unless it is below.
bool takes(int r, int step) {
    return r % (2 * step) == 0;
}

std::span<std::byte> bytes_of(std::uint64_t& word) {
    return std::as_writable_bytes(std::span(&word, 1));
}

}  // namespace

void hand_up(const Ranks& ranks, const std::function<void(int from)>& take,
             const std::function<void(int to)>& give) {
    for (int step = 1; step < ranks.size; step *= 2) {
        if (!takes(ranks.rank, step)) return give(ranks.rank - step);
        if (ranks.rank + step < ranks.size) take(ranks.rank + step);
    }
}

void broadcast(const Ranks& ranks, std::span<std::byte> bytes) {
    int step = 1;
    while (step < ranks.size && takes(ranks.rank, step)) step *= 2;
    if (!ranks.is_first()) ranks.receive(ranks.rank - step, bytes);
    for (step /= 2; step > 0; step /= 2)
        if (ranks.rank + step < ranks.size) ranks.send(ranks.rank + step, bytes);
}

void send_text(const Ranks& ranks, int to, const std::string& text) {
    std::uint64_t size = text.size();
    ranks.send(to, bytes_of(size));
    if (size > 0) ranks.send(to, std::as_bytes(std::span(text)));
}

std::string receive_text(const Ranks& ranks, int from) {
    std::uint64_t size = 0;
    ranks.receive(from, bytes_of(size));
    std::string text(size, '\0');
    if (size > 0) ranks.receive(from, std::as_writable_bytes(std::span(text)));
    return text;
}

std::string first_text(const Ranks& ranks, const std::string& mine) {
    std::string first = mine;
    const auto take = [&](int from) {
        const std::string text = receive_text(ranks, from);
        if (first.empty()) first = text;
    };
    hand_up(ranks, take, [&](int to) { send_text(ranks, to, first); });
    std::uint64_t size = first.size();
    broadcast(ranks, bytes_of(size));
    first.resize(size);
    if (size > 0) broadcast(ranks, std::as_writable_bytes(std::span(first)));
    return first;
}

}  // namespace sunfleck::engine
