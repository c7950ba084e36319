// Ranks that are threads of one process: what MPI does, without it.
#pragma once

#include "ranks/ranks.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace sunfleck::engine::testing_support {

/// Bytes on their way, by sender and receiver.
class Post {
public:
    void send(int from, int to, std::span<const std::byte> bytes) {
        const std::lock_guard lock(mutex_);
        if (bytes.empty()) throw std::logic_error("sends nothing, which no rank may");
        letters_[{from, to}].emplace_back(bytes.begin(), bytes.end());
        sent_ += bytes.size();
        arrived_.notify_all();
    }
    void receive(int from, int to, std::span<std::byte> bytes) {
        std::unique_lock lock(mutex_);
        auto& letters = letters_[{from, to}];
        if (!arrived_.wait_for(lock, std::chrono::seconds(60), [&] { return !letters.empty(); }))
            throw std::runtime_error("waits in vain");
        if (letters.front().size() != bytes.size()) throw std::logic_error("another size is sent");
        std::memcpy(bytes.data(), letters.front().data(), bytes.size());
        letters.pop_front();
    }
    /// By all ranks.
    std::size_t sent() const { return sent_; }
    /// Has all that was sent been received?
    bool is_empty() const {
        return std::all_of(letters_.begin(), letters_.end(),
                           [](const auto& way) { return way.second.empty(); });
    }

private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::map<std::pair<int, int>, std::deque<std::vector<std::byte>>> letters_;
    std::size_t sent_ = 0;
};

inline Ranks rank_of(Post& post, int rank, int size) {
    return {rank, size, [&post, rank](int to, auto bytes) { post.send(rank, to, bytes); },
            [&post, rank](int from, auto bytes) { post.receive(from, rank, bytes); }};
}

/// Runs task(ranks) on `size` ranks at once; rethrows the fault of the lowest one that had any.
/// @return bytes sent by all.
template <class Task>
std::size_t on_ranks(int size, const Task& task) {
    Post post;
    std::vector<std::exception_ptr> faults(static_cast<std::size_t>(size));
    const auto run = [&](int rank) {
        try {
            task(rank_of(post, rank, size));
        } catch (const std::exception&) {
            faults[static_cast<std::size_t>(rank)] = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    threads.reserve(faults.size());
    for (int rank = 0; rank < size; ++rank) threads.emplace_back(run, rank);
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& fault : faults)
        if (fault) std::rethrow_exception(fault);
    if (!post.is_empty()) throw std::logic_error("something sent was never received");
    return post.sent();
}

}  // namespace sunfleck::engine::testing_support
