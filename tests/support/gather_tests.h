// The visible points that take a photon, found the plain way: box by box, disc by disc.
#pragma once

#include "visible_points/visible_point_index.h"

#include <algorithm>

namespace sunfleck::engine::testing_support {

inline bool is_inside(const Vec3& place, const Box& box) {
    for (int c = 0; c < 3; ++c)
        if (!(place[c] >= box.low[c] && place[c] <= box.high[c])) return false;
    return true;
}

/// Calls found(point) for every point that accepts the photon and whose block's box holds it.
/// @return whether any does.
template <class Found>
bool for_each_accepting(const VisiblePointIndex& index, const Photon& photon, const Found& found) {
    constexpr std::size_t kWidth = VisiblePointIndex::kWidth;
    const std::span<const VisiblePoint> points = index.points();
    bool any = false;
    for (std::size_t b = 0; b < index.block_count(); ++b) {
        if (!is_inside(photon.position, index.around(photon.kind).boxes[b])) continue;
        for (std::size_t i = b * kWidth; i < std::min((b + 1) * kWidth, points.size()); ++i) {
            if (!accepts(points[i].disc, photon, index.max_depth())) continue;
            found(points[i]);
            any = true;
        }
    }
    return any;
}

}  // namespace sunfleck::engine::testing_support
