// Ranks: processes on one or more machines that render one picture together.
//
// A rank can send bytes to another one and receive them; everything else is built on that, along a
// binary tree over neighbours: rank r + s sends to rank r, for s = 1, 2, 4 ... and r a multiple of
// 2s. So the data collected by rank r are those of ranks r, r + 1, ... without a gap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace sunfleck::engine {

/// The view of one rank. By default it is alone.
struct Ranks {
    int rank = 0;
    int size = 1;
    /// Transfer to and from another rank, in sending order; both wait for each other. Not empty.
    std::function<void(int to, std::span<const std::byte> bytes)> send;
    std::function<void(int from, std::span<std::byte> bytes)> receive;

    bool is_first() const { return rank == 0; }
    bool is_alone() const { return size == 1; }
};

/// Calls take(rank) for each child of this rank in the tree, in ascending order, then give(rank)
/// for its parent; rank 0 has none.
void hand_up(const Ranks& ranks, const std::function<void(int from)>& take,
             const std::function<void(int to)>& give);

/// Sends rank 0's bytes to all; every rank calls it with a buffer of the same size.
void broadcast(const Ranks& ranks, std::span<std::byte> bytes);

/// Sends a text to another rank.
void send_text(const Ranks& ranks, int to, const std::string& text);
std::string receive_text(const Ranks& ranks, int from);

/// Returns the text of the lowest rank that has one, on every rank; empty if none has.
std::string first_text(const Ranks& ranks, const std::string& mine);

}  // namespace sunfleck::engine
