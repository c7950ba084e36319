// Points next to edges, with a light sample at each.
#include "photon/edge_search.h"

#include "core/parallel.h"
#include "geometry/affine.h"
#include "math/warp.h"
#include "photon/initial_guide_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

struct Edge {
    Vec3d from;
    Vec3d to;
};

/// Triangles or patches of one placed shape.
struct EdgedShape {
    const Shape* shape;
    Affine to_world;
    std::size_t end;  // cumulative count of triangles or patches
};

/// Corners per element and number of elements of a shape; none for shapes without edges.
struct Elements {
    std::size_t corners = 0;
    std::size_t count = 0;
};

Elements elements_of(const Shape& shape) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) return {3, mesh->triangles.size()};
    if (const auto* mesh = std::get_if<BilinearMesh>(&shape)) return {4, mesh->patches.size()};
    return {};
}

class Edges {
public:
    explicit Edges(const GeometryInput& input) {
        input.for_each_placed(
            [&](std::uint32_t shape, const Matrix& outer) { add(input.shapes[shape], outer); });
    }

    bool empty() const { return shapes_.empty(); }

    /// Selects an edge: half of the time uniformly over all triangles, half of the time uniformly
    /// over shapes, because a door among statues is one shape of a few triangles. @param which,
    /// element, side  in (0,1).
    Edge choose(double which, double element, double side) const {
        const bool by_part = which < 0.5;
        const double at = by_part ? 2 * which : 2 * which - 1;
        const auto total = static_cast<double>(shapes_.back().end);
        const auto shape =
            by_part ? shape_of(static_cast<std::size_t>(at * total))
                    : shapes_.begin() +
                          static_cast<std::ptrdiff_t>(at * static_cast<double>(shapes_.size()));
        const Elements elements = elements_of(*shape->shape);
        return edge(*shape, static_cast<std::size_t>(element * static_cast<double>(elements.count)),
                    static_cast<std::size_t>(side * static_cast<double>(elements.corners)));
    }

private:
    using Shapes = std::vector<EdgedShape>;

    void add(const PlacedShape& placed, const Matrix& outer) {
        const Elements elements = elements_of(placed.shape);
        if (elements.count == 0) return;
        const std::size_t before = shapes_.empty() ? 0 : shapes_.back().end;
        shapes_.push_back(
            {&placed.shape, Affine(placed.to_world * outer), before + elements.count});
    }

    Shapes::const_iterator shape_of(std::size_t element) const {
        return std::upper_bound(shapes_.begin(), shapes_.end() - 1, element,
                                [](std::size_t i, const EdgedShape& s) { return i < s.end; });
    }

    static Edge edge(const EdgedShape& of, std::size_t element, std::size_t side) {
        const auto place = [&](const std::vector<Vec3>& positions, std::uint32_t corner) {
            constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
            if (corner >= positions.size()) return Vec3d(kNowhere);
            return of.to_world.point(Vec3d(positions[corner]));
        };
        if (const auto* mesh = std::get_if<TriangleMesh>(of.shape)) {
            const auto& corners = mesh->triangles[element];
            return {place(mesh->positions, corners.at(side)),
                    place(mesh->positions, corners.at((side + 1) % 3))};
        }
        constexpr std::array<std::size_t, 4> kAround = {0, 1, 3, 2};  // around a patch's corners
        const auto& mesh = std::get<BilinearMesh>(*of.shape);
        const auto& corners = mesh.patches[element];
        return {place(mesh.positions, corners.at(kAround.at(side))),
                place(mesh.positions, corners.at(kAround.at((side + 1) % 4)))};
    }

    Shapes shapes_;
};

/// Samples a point next to the edge: at 2^-16 to 1 of its length, log-uniform.
Vec3 point_by(const Edge& edge, RandomStream& stream) {
    constexpr double kOctaves = 16;
    const Vec3d way = edge.to - edge.from;
    const Vec3d on = edge.from + way * stream.next();
    const double distance = way.length() * std::exp2(static_cast<float>(-kOctaves * stream.next()));
    const double first = stream.next();
    const Vec3 point(on + uniform_sphere({first, stream.next()}) * distance);
    return point;
}

}  // namespace

std::vector<WeightedEmission> emission_past_edges(const PhotonContext& photon_context,
                                                  const LightChoice& lights, PassId pass,
                                                  const PathRange& tries) {
    constexpr std::size_t kBlock = 1024;
    const Edges edges(photon_context.scene.scene.geometry().input());
    if (edges.empty()) return {};
    const InitialGuideSamples guide_samples(photon_context.scene, lights);
    std::vector<std::vector<WeightedEmission>> blocks((tries.size() + kBlock - 1) / kBlock);
    parallel_blocks(tries.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            RandomStream stream = pass.stream(Purpose::edge_search, tries.begin + i);
            const double which = stream.next();
            const double element = stream.next();
            const Vec3 at = point_by(edges.choose(which, element, stream.next()), stream);
            if (!std::isfinite(at.x + at.y + at.z)) continue;
            const auto light = guide_samples.sample(at, stream);
            if (!light) continue;
            if (guide_samples.panes_to({at, light->direct.direction}, light->direct.distance) < 0)
                continue;
            if (const auto guide_sample = guide_samples.guide_sample(*light, at, 1, stream))
                blocks[begin / kBlock].push_back(*guide_sample);
        }
    });
    std::vector<WeightedEmission> all;
    for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
    return all;
}

}  // namespace sunfleck::engine
