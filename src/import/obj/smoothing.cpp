// Sums of face normals per vertex and group, in lists per vertex.
#include "import/obj/smoothing.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// The normal of a vertex in one group.
struct GroupNormal {
    std::uint32_t group = 0;
    std::uint32_t next = kNoIndex;  // of the same vertex
    Vec3d sum{0};
};

class GroupNormals {
public:
    explicit GroupNormals(std::size_t vertices) : first_(vertices, kNoIndex) {}

    /// Returns the index of a vertex's normal in a group, which is made at its first use.
    std::uint32_t at(std::uint32_t vertex, std::uint32_t group) {
        for (std::uint32_t i = first_[vertex]; i != kNoIndex; i = all_[i].next)
            if (all_[i].group == group) return i;
        all_.push_back({group, first_[vertex]});
        return first_[vertex] = static_cast<std::uint32_t>(all_.size() - 1);
    }
    void add(std::uint32_t index, const Vec3d& normal) { all_[index].sum += normal; }
    const std::vector<GroupNormal>& all() const { return all_; }

private:
    std::vector<std::uint32_t> first_;  // by vertex
    std::vector<GroupNormal> all_;
};

/// Returns the angle between two vectors. In float all machines have the same bits of atan2.
double angle_between(const Vec3d& a, const Vec3d& b) {
    return static_cast<double>(
        std::atan2(static_cast<float>(a.cross(b).length()), static_cast<float>(a.dot(b))));
}

class Smoother {
public:
    explicit Smoother(ObjMesh& mesh) : mesh_(mesh), normals_(mesh.positions.size()) {
        mesh_.normal_corners.resize(mesh_.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
    }

    void run() {
        const auto begin = static_cast<std::uint32_t>(mesh_.normals.size());
        for_each_triangle([&](std::size_t t, std::uint32_t group) { add(t, group); });
        for (const GroupNormal& normal : normals_.all())
            mesh_.normals.emplace_back(normal.sum.normalized());
        for_each_triangle([&](std::size_t t, std::uint32_t group) {
            ObjTriangle corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t index = normals_.at(mesh_.triangles[t].at(k), group);
                if (!(normals_.all()[index].sum.length2() > 0)) return;
                corners.at(k) = begin + index;
            }
            mesh_.normal_corners[t] = corners;
        });
    }

private:
    /// Calls visit(triangle, group) for triangles of a group without normals.
    template <class Visit>
    void for_each_triangle(const Visit& visit) {
        for (std::size_t r = 0; r < mesh_.runs.size(); ++r) {
            const std::uint32_t group = mesh_.runs[r].smoothing;
            if (group == 0) continue;
            const std::size_t end =
                r + 1 < mesh_.runs.size() ? mesh_.runs[r + 1].first : mesh_.triangles.size();
            for (std::size_t t = mesh_.runs[r].first; t < end; ++t)
                if (mesh_.normal_corners[t][0] == kNoIndex) visit(t, group);
        }
    }

    void add(std::size_t t, std::uint32_t group) {
        const ObjTriangle& corners = mesh_.triangles[t];
        std::array<Vec3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p.at(k) = mesh_.positions[corners.at(k)];
        const Vec3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& here = p.at(k);
            const double angle = angle_between(p.at((k + 1) % 3) - here, p.at((k + 2) % 3) - here);
            normals_.add(normals_.at(corners.at(k), group), normal * angle);
        }
    }

    ObjMesh& mesh_;
    GroupNormals normals_;
};

}  // namespace

std::size_t drop_broken_normals(ObjMesh& mesh) {
    constexpr ObjTriangle kNone = {kNoIndex, kNoIndex, kNoIndex};
    const auto is_broken = [&](std::uint32_t n) {
        if (n == kNoIndex) return true;
        const float length2 = mesh.normals[n].length2();
        return !(length2 > 0 && std::isfinite(length2));
    };
    std::size_t dropped = 0;
    for (ObjTriangle& t : mesh.normal_corners) {
        if (t == kNone || std::none_of(t.begin(), t.end(), is_broken)) continue;
        t = kNone;
        ++dropped;
    }
    return dropped;
}

void smooth(ObjMesh& mesh) {
    const bool has_groups = std::any_of(mesh.runs.begin(), mesh.runs.end(),
                                        [](const ObjRun& run) { return run.smoothing != 0; });
    if (has_groups) Smoother(mesh).run();
}

}  // namespace sunfleck::engine
