// Lists that come without their first values: whoever makes one writes every item before it is
// read, each thread its own.
//
// A list that is filled with zeros first is filled, and its memory entered, by one thread.
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

namespace sunfleck::engine {

/// An allocator that leaves items that are given no value as the memory is.
template <class T>
struct Unfilled : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>);
    Unfilled() = default;
    template <class U>
    Unfilled(const Unfilled<U>&) {}

    /// Of an item without a value; those with one are made as ever.
    template <class U>
    void construct(U* /*place*/) {}
};

template <class T>
using UnfilledVector = std::vector<T, Unfilled<T>>;

}  // namespace sunfleck::engine
