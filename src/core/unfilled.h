// Vectors without initial values: the owner writes every element before it is read.
//
// A vector that is zeroed first is touched, and its memory mapped, by one thread alone.
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

namespace sunfleck::engine {

/// Allocator that leaves elements without a given value uninitialised.
template <class T>
struct Unfilled : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>);
    Unfilled() = default;
    template <class U>
    Unfilled(const Unfilled<U>&) {}

    /// Constructs nothing for an element without a value; elements with a value use the default.
    template <class U>
    void construct(U* /*place*/) {}
};

template <class T>
using UnfilledVector = std::vector<T, Unfilled<T>>;

}  // namespace sunfleck::engine
