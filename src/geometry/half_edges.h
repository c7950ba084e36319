// The neighbourhood of vertices in a mesh of triangles: half-edges, one each side of an edge.
//
// Half-edge 3 f + i runs along triangle f from its corner i to the next.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class HalfEdges {
public:
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    static constexpr std::uint32_t kNoEdge = 0xFFFFFFFF;

    /// Keeps the list by reference. @param vertices  more than any index in it.
    HalfEdges(const Triangles& triangles, std::size_t vertices);

    /// Does each half-edge stand alone between its two vertices?
    bool is_regular() const { return is_regular_; }
    std::uint32_t from(std::uint32_t edge) const { return triangles_[edge / 3][edge % 3]; }
    std::uint32_t to(std::uint32_t edge) const { return from(next(edge)); }
    static std::uint32_t next(std::uint32_t edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
    static std::uint32_t previous(std::uint32_t edge) {
        return edge % 3 == 0 ? edge + 2 : edge - 1;
    }
    /// The other side, or none at the border.
    std::uint32_t twin(std::uint32_t edge) const { return twin_[edge]; }
    /// One that leaves the vertex: at the border the one along which there is nothing on the right.
    /// None if no triangle has the vertex.
    std::uint32_t leaving(std::uint32_t vertex) const { return leaving_[vertex]; }
    bool on_border(std::uint32_t vertex) const { return twin_[leaving_[vertex]] == kNoEdge; }
    /// The neighbours of a vertex, counter-clockwise; at the border from one end to the other.
    void ring(std::uint32_t vertex, std::vector<std::uint32_t>& result) const;

private:
    const Triangles& triangles_;
    std::vector<std::uint32_t> twin_;
    std::vector<std::uint32_t> leaving_;
    bool is_regular_ = true;
};

}  // namespace sunfleck::engine
