// Components by union and find, with the relative order of corners; hollows by a parity of
// crossings.
#include "geometry/closed_surface.h"

#include "geometry/bounds.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace sunfleck::engine {
namespace {

using SurfaceTriangle = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNoComponent = 0xFFFFFFFF;

/// Sets of triangles, each with whether it is reversed against the first of its set.
class OrientedSets {
public:
    explicit OrientedSets(std::size_t count) : parents_(count), reversed_(count) {
        std::iota(parents_.begin(), parents_.end(), 0U);
    }

    std::uint32_t root(std::uint32_t i) {
        bool against_root = false;
        std::uint32_t top = i;
        for (; parents_[top] != top; top = parents_[top])
            against_root = against_root != reversed_[top];
        while (parents_[i] != top && i != top) {  // shortens the way
            const std::uint32_t next = parents_[i];
            const bool against_next = reversed_[i];
            parents_[i] = top;
            reversed_[i] = against_root;
            against_root = against_root != against_next;
            i = next;
        }
        return top;
    }
    /// Returns whether i is reversed against its root.
    bool is_reversed(std::uint32_t i) {
        root(i);
        return parents_[i] != i && reversed_[i];
    }
    /// @param against  whether one must be reversed for both to face one side.
    void join(std::uint32_t a, std::uint32_t b, bool against) {
        const bool a_against = is_reversed(a);
        const bool b_against = is_reversed(b);
        const std::uint32_t root_a = root(a);
        const std::uint32_t root_b = root(b);
        if (root_a == root_b) return;
        parents_[root_a] = root_b;
        reversed_[root_a] = (a_against != b_against) != against;
    }

private:
    std::vector<std::uint32_t> parents_;
    std::vector<bool> reversed_;  // against the parent
};

/// A side of a triangle, from its lower vertex to the higher.
struct Side {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    bool goes_up = false;  // as the triangle has it
};

std::vector<Side> sorted_sides(std::span<const SurfaceTriangle> triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const SurfaceTriangle& v = triangles[t];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = v.at(k);
            const std::uint32_t b = v.at((k + 1) % 3);
            sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

/// A closed component.
struct Component {
    std::vector<std::uint32_t> triangles{};
    Bounds bounds{};
    double volume = 0;  // positive if its triangles face outwards
};

class SideFinder {
public:
    SideFinder(std::span<const Vec3> positions, std::span<const SurfaceTriangle> triangles)
        : positions_(positions), triangles_(triangles), sets_(triangles.size()) {}

    SurfaceSides run() {
        SurfaceSides sides;
        sides.is_closed = closed();
        sides.is_reversed.resize(triangles_.size(), false);
        collect(sides.is_closed);
        for (const Component& component : components_) {
            const bool turns = component.volume < 0 && !is_hollow(component);
            for (const std::uint32_t t : component.triangles)
                sides.is_reversed[t] = sets_.is_reversed(t) != turns;
        }
        return sides;
    }

private:
    std::vector<bool> closed() {
        const std::vector<Side> sides = sorted_sides(triangles_);
        std::vector<bool> has_open_side(triangles_.size(), false);
        for (std::size_t begin = 0; begin < sides.size();) {
            std::size_t end = begin + 1;
            while (end < sides.size() && sides[end].low == sides[begin].low &&
                   sides[end].high == sides[begin].high)
                ++end;
            const Side& first = sides[begin];
            if (end - begin == 2)
                sets_.join(first.triangle, sides[begin + 1].triangle,
                           first.goes_up == sides[begin + 1].goes_up);
            for (std::size_t i = begin; i < end && (end - begin) % 2 != 0; ++i)
                has_open_side[sides[i].triangle] = true;
            begin = end;
        }
        std::vector<bool> is_open(triangles_.size(), false);  // by root
        for (std::uint32_t t = 0; t < triangles_.size(); ++t)
            if (has_open_side[t] || is_flat(t)) is_open[sets_.root(t)] = true;
        std::vector<bool> is_closed(triangles_.size());
        for (std::uint32_t t = 0; t < triangles_.size(); ++t)
            is_closed[t] = !is_open[sets_.root(t)];
        return is_closed;
    }

    bool is_flat(std::uint32_t t) const {
        const SurfaceTriangle& v = triangles_[t];
        return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    }

    Vec3d corner(std::uint32_t t, std::size_t k) const {
        const Vec3& p = positions_[triangles_[t].at(k)];
        return {p.x, p.y, p.z};
    }

    void collect(const std::vector<bool>& is_closed) {
        std::vector<std::uint32_t> numbers(triangles_.size(), kNoComponent);  // by root
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (!is_closed[t]) continue;
            std::uint32_t& number = numbers[sets_.root(t)];
            if (number == kNoComponent) {
                number = static_cast<std::uint32_t>(components_.size());
                components_.emplace_back();
            }
            Component& component = components_[number];
            component.triangles.push_back(t);
            for (std::size_t k = 0; k < 3; ++k) component.bounds.extend(corner(t, k));
        }
        for (Component& component : components_) {
            const Vec3d origin = component.bounds.center();
            for (const std::uint32_t t : component.triangles) {
                const double volume =
                    (corner(t, 0) - origin)
                        .dot((corner(t, 1) - origin).cross(corner(t, 2) - origin));
                component.volume += sets_.is_reversed(t) ? -volume : volume;
            }
        }
    }

    static bool contains(const Bounds& outer, const Bounds& inner) {
        for (int c = 0; c < 3; ++c)
            if (inner.min[c] < outer.min[c] || inner.max[c] > outer.max[c]) return false;
        return true;
    }

    /// Returns whether a component lies within an odd number of others. Where that would take too
    /// long, it is taken for a hollow, and stays as it is.
    bool is_hollow(const Component& component) {
        constexpr std::size_t kMostTests = 2000000000;
        const Vec3d point = (corner(component.triangles[0], 0) + corner(component.triangles[0], 1) +
                             corner(component.triangles[0], 2)) /
                            3;
        bool is_inside = false;
        for (const Component& other : components_) {
            if (&other == &component || !contains(other.bounds, component.bounds)) continue;
            tests_ += other.triangles.size();
            if (tests_ > kMostTests) return true;
            for (const std::uint32_t t : other.triangles)
                if (is_above(point, t)) is_inside = !is_inside;
        }
        return is_inside;
    }

    /// Returns whether a ray from the point upwards, at a slant that no edge shares, meets a
    /// triangle.
    bool is_above(const Vec3d& point, std::uint32_t t) const {
        static const Vec3d ray(0.01234567, 0.00345678, 1);
        const Vec3d a = corner(t, 0) - point;
        const Vec3d b = corner(t, 1) - point;
        const Vec3d c = corner(t, 2) - point;
        const double u = ray.dot(b.cross(c));
        const double v = ray.dot(c.cross(a));
        const double w = ray.dot(a.cross(b));
        if ((u < 0) != (v < 0) || (v < 0) != (w < 0)) return false;
        const double sum = u + v + w;
        return sum != 0 && a.dot(b.cross(c)) / sum > 0;
    }

    std::span<const Vec3> positions_;
    std::span<const SurfaceTriangle> triangles_;
    OrientedSets sets_;
    std::vector<Component> components_;
    std::size_t tests_ = 0;
};

}  // namespace

SurfaceSides sides_of(std::span<const Vec3> positions,
                      std::span<const std::array<std::uint32_t, 3>> triangles) {
    return SideFinder(positions, triangles).run();
}

double mean_chord_of(std::span<const Vec3> positions,
                     std::span<const std::array<std::uint32_t, 3>> triangles) {
    double volume = 0;
    double area = 0;
    for (const auto& t : triangles) {
        const Vec3d origin(positions[triangles[0][0]]);
        const Vec3d a = Vec3d(positions[t[0]]) - origin;
        const Vec3d b = Vec3d(positions[t[1]]) - origin;
        const Vec3d c = Vec3d(positions[t[2]]) - origin;
        volume += a.dot(b.cross(c)) / 6;
        area += (b - a).cross(c - a).length() / 2;
    }
    return area > 0 ? 4 * std::abs(volume) / area : 0;
}

}  // namespace sunfleck::engine
