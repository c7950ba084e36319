// Ranks: processes, on one machine or many, that render one picture together.
//
// What a rank can do is to send bytes to another one and to receive them; all else is made of that,
// along a binary tree over neighbours: rank r + s hands up to rank r, for s = 1, 2, 4 ... and r a
// multiple of 2s. So what rank r has gathered is of the ranks r, r + 1, ... without a gap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace sunfleck::engine {

/// One rank's view of all. Without a word: alone.
struct Ranks {
    int rank = 0;
    int size = 1;
    /// To and from another rank, in the order of sending; both wait for each other. Not empty.
    std::function<void(int to, std::span<const std::byte> bytes)> send;
    std::function<void(int from, std::span<std::byte> bytes)> receive;

    bool is_first() const { return rank == 0; }
    bool is_alone() const { return size == 1; }
};

/// Calls take(rank) for each rank that hands up to this one, in ascending order, then give(rank)
/// for the one that this hands up to; rank 0 has none.
void hand_up(const Ranks& ranks, const std::function<void(int from)>& take,
             const std::function<void(int to)>& give);

/// Rank 0's bytes reach all; every rank calls it with room for as many.
void broadcast(const Ranks& ranks, std::span<std::byte> bytes);

/// A text from one rank to another.
void send_text(const Ranks& ranks, int to, const std::string& text);
std::string receive_text(const Ranks& ranks, int from);

/// The text of the lowest rank that has one, on every rank; empty if none has.
std::string first_text(const Ranks& ranks, const std::string& mine);

}  // namespace sunfleck::engine
