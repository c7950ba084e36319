// Visible points in one list.
#pragma once

#include "visible_points/visible_point.h"

namespace sunfleck::engine::testing_support {

/// In the order of the lists.
inline std::vector<VisiblePoint> joined(const VisiblePointLists& lists) {
    std::vector<VisiblePoint> all;
    for (const std::vector<VisiblePoint>& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace sunfleck::engine::testing_support
