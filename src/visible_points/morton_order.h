// The items of several lists, all in one Morton order.
#pragma once

#include "core/parallel.h"
#include "visible_points/morton.h"

#include <vector>

namespace sunfleck::engine {

/// Equal codes are in the order of the lists.
/// @param size_of  size_of(list). @param code_of  code_of(list, item), of 63 bits. @param bits  as
/// sort_by_code().
template <class SizeOf, class CodeOf>
MortonKeys in_morton_order(std::size_t lists, const SizeOf& size_of, const CodeOf& code_of,
                           unsigned bits) {
    std::vector<std::size_t> first(lists + 1, 0);
    for (std::size_t l = 0; l < lists; ++l) first[l + 1] = first[l] + size_of(l);
    MortonKeys keys(first.back());
    parallel_for(lists, [&](std::size_t l) {
        const std::size_t size = size_of(l);
        for (std::size_t i = 0; i < size; ++i)
            keys[first[l] + i] = {code_of(l, i), static_cast<std::uint32_t>(i),
                                  static_cast<std::uint32_t>(l)};
    });
    sort_by_code(keys, bits);
    return keys;
}

}  // namespace sunfleck::engine
