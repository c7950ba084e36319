// Pairs of half-edges, found by sorting.
#include "geometry/half_edges.h"

#include <algorithm>

namespace sunfleck::engine {

HalfEdges::HalfEdges(const Triangles& triangles, std::size_t vertices)
    : triangles_(triangles), twin_(3 * triangles.size(), kNoEdge), leaving_(vertices, kNoEdge) {
    struct Named {
        std::uint32_t low, high, edge;
        bool rises;
    };
    std::vector<Named> all;
    all.reserve(twin_.size());
    for (std::uint32_t e = 0; e < twin_.size(); ++e) {
        const auto [low, high] = std::minmax({from(e), to(e)});
        all.push_back({low, high, e, from(e) == low});
        is_regular_ = is_regular_ && low != high;
    }
    std::sort(all.begin(), all.end(), [](const Named& a, const Named& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.edge < b.edge;
    });
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const Named& a = all[i];
        const Named& b = all[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        if (a.rises == b.rises || twin_[a.edge] != kNoEdge) is_regular_ = false;
        twin_[a.edge] = b.edge;
        twin_[b.edge] = a.edge;
    }
    for (std::uint32_t e = 0; e < twin_.size(); ++e) {
        std::uint32_t& out = leaving_[from(e)];
        if (out == kNoEdge || twin_[e] == kNoEdge) out = e;
    }
}

void HalfEdges::ring(std::uint32_t vertex, std::vector<std::uint32_t>& result) const {
    result.clear();
    const std::uint32_t first = leaving_[vertex];
    std::uint32_t edge = first;
    do {
        result.push_back(to(edge));
        const std::uint32_t arriving = previous(edge);
        edge = twin_[arriving];
        if (edge == kNoEdge) result.push_back(from(arriving));
    } while (edge != kNoEdge && edge != first && result.size() <= triangles_.size() + 1);
}

}  // namespace sunfleck::engine
