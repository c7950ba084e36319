// Lists that come without their first values: whoever makes one writes every item before it is
// read, each thread its own.
//
// A list that is filled with zeros first is filled, and its memory entered, by one thread.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace sunfleck {

/// An allocator that leaves items that are given no value as the memory is.
template <class T>
struct Unfilled : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>);
    template <class U>
    struct rebind {  // NOLINT(readability-identifier-naming): the name containers ask for
        using other = Unfilled<U>;  // NOLINT(readability-identifier-naming): the same
    };

    Unfilled() = default;
    template <class U>
    Unfilled(const Unfilled<U>&) {}

    template <class U>
    void construct(U* /*place*/) {}
    template <class U, class... Values>
    void construct(U* place, Values&&... values) {
        ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
    }
};

template <class T>
using UnfilledVector = std::vector<T, Unfilled<T>>;

}  // namespace sunfleck
