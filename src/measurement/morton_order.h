// The items of several lists, all in one Morton order.
#pragma once

#include "core/parallel.h"
#include "measurement/morton.h"

#include <vector>

namespace sunfleck {

/// Equal codes are in the order of the lists.
/// @param size_of   size_of(list). @param place_of  place_of(list, item) -> Vec3.
/// @param bits      as sort_by_code().
template <class SizeOf, class PlaceOf>
MortonKeys in_morton_order(std::size_t lists, const SizeOf& size_of, const PlaceOf& place_of,
                           const MortonGrid& grid, unsigned bits) {
    std::vector<std::size_t> first(lists + 1, 0);
    for (std::size_t l = 0; l < lists; ++l) first[l + 1] = first[l] + size_of(l);
    MortonKeys keys(first.back());
    parallel_for(lists, [&](std::size_t l) {
        const std::size_t size = size_of(l);
        for (std::size_t i = 0; i < size; ++i)
            keys[first[l] + i] = {grid.code(place_of(l, i)), static_cast<std::uint32_t>(i),
                                  static_cast<std::uint32_t>(l)};
    });
    sort_by_code(keys, bits);
    return keys;
}

}  // namespace sunfleck
