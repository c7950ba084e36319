// Fans while the file is read, ears where a fan would not do: by then all vertices are known.
#include "import/obj/faces.h"

#include "import/obj/ear_clipping.h"
#include "import/ply/polygons.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kMostCorners = 100000;  // of a face
constexpr std::size_t kMostToClip = 5000;     // of one that is no fan
constexpr ObjTriangle kNoCorners = {kNoIndex, kNoIndex, kNoIndex};

bool is_same_run(const ObjRun& a, const ObjRun& b) {
    return a.material == b.material && a.smoothing == b.smoothing && a.object == b.object;
}

}  // namespace

void ObjFaces::push(const ObjCorner& a, const ObjCorner& b, const ObjCorner& c) {
    if (runs_.empty() || !is_same_run(runs_.back(), run_)) {
        run_.first = triangles_.size();
        runs_.push_back(run_);
    }
    triangles_.push_back({a[0], b[0], c[0]});
    for (std::size_t list = 1; list < kObjLists; ++list) {
        const bool has_any =
            a.at(list) != kNoIndex || b.at(list) != kNoIndex || c.at(list) != kNoIndex;
        auto& corners = others_.at(list - 1);
        if (!has_any && corners.empty()) continue;
        corners.resize(triangles_.size() - 1, kNoCorners);
        corners.push_back({a.at(list), b.at(list), c.at(list)});
    }
}

void ObjFaces::add(std::span<const ObjCorner> corners, const TextCursor& cursor) {
    if (corners.size() < 3) {
        ++counts_.small;
        return;
    }
    if (corners.size() > kMostCorners)
        cursor.fail(cursor.offset(), "a face of more than 100000 corners", "triangulate the mesh");
    if (corners.size() > 3)
        fans_.push_back({triangles_.size(), static_cast<std::uint32_t>(corners.size())});
    for (std::size_t i = 2; i < corners.size(); ++i) push(corners[0], corners[i - 1], corners[i]);
}

std::vector<ObjCorner> ObjFaces::corners_of(const Fan& fan) const {
    std::vector<ObjCorner> corners;
    const auto take = [&](std::size_t triangle, std::size_t k) {
        const auto other = [&](std::size_t list) {
            const auto& all = others_.at(list);
            return triangle < all.size() ? all[triangle].at(k) : kNoIndex;
        };
        corners.push_back({triangles_[triangle].at(k), other(0), other(1)});
    };
    take(fan.first, 0);
    take(fan.first, 1);
    for (std::size_t i = 0; i + 2 < fan.corners; ++i) take(fan.first + i, 2);
    return corners;
}

void ObjFaces::set(std::size_t triangle, const std::array<ObjCorner, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
        triangles_[triangle].at(k) = corners.at(k)[0];
        for (std::size_t list = 1; list < kObjLists; ++list) {
            auto& all = others_.at(list - 1);
            if (triangle < all.size()) all[triangle].at(k) = corners.at(k).at(list);
        }
    }
}

void ObjFaces::triangulate(const Fan& fan, const ObjMesh& mesh) {
    const auto place = [&](std::size_t triangle, std::size_t k) {
        return mesh.positions[triangles_[triangle].at(k)];
    };
    if (fan.corners == 4 && is_convex_quad({place(fan.first, 0), place(fan.first, 1),
                                            place(fan.first, 2), place(fan.first + 1, 2)}))
        return;
    const std::vector<ObjCorner> corners = corners_of(fan);
    std::vector<Vec3d> places;
    for (const ObjCorner& corner : corners) places.push_back(mesh.positions[corner[0]]);
    if (fan.corners > 4 && is_planar_and_convex(places)) return;
    if (fan.corners > kMostToClip) {
        ++counts_.crossing;
        return;
    }
    const Triangulation cut = triangulated(places);
    if (!cut.is_simple) ++counts_.crossing;
    for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
        const auto& t = cut.triangles[i];
        set(fan.first + i, {corners[t[0]], corners[t[1]], corners[t[2]]});
    }
}

void ObjFaces::remove_flat(ObjMesh& mesh) {
    const auto is_flat = [](const ObjTriangle& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    };
    std::size_t kept = 0;
    std::size_t run = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (; run < mesh.runs.size() && mesh.runs[run].first == t; ++run)
            mesh.runs[run].first = kept;
        if (is_flat(mesh.triangles[t])) {
            ++counts_.flat;
            continue;
        }
        for (auto* list : {&mesh.triangles, &mesh.uv_corners, &mesh.normal_corners})
            if (!list->empty()) (*list)[kept] = (*list)[t];
        ++kept;
    }
    for (auto* list : {&mesh.triangles, &mesh.uv_corners, &mesh.normal_corners})
        if (!list->empty()) list->resize(kept);
    // Of runs that begin at one triangle, or behind the last, all but the last are empty.
    std::vector<ObjRun> filled;
    for (std::size_t r = 0; r < mesh.runs.size(); ++r) {
        const std::size_t end = r + 1 < mesh.runs.size() ? mesh.runs[r + 1].first : kept;
        if (mesh.runs[r].first < end) filled.push_back(mesh.runs[r]);
    }
    mesh.runs = std::move(filled);
}

ObjFaceCounts ObjFaces::finish(ObjMesh& mesh) {
    for (const Fan& fan : fans_) triangulate(fan, mesh);
    for (auto& corners : others_)
        if (!corners.empty()) corners.resize(triangles_.size(), kNoCorners);
    mesh.triangles = std::move(triangles_);
    mesh.uv_corners = std::move(others_[0]);
    mesh.normal_corners = std::move(others_[1]);
    mesh.runs = std::move(runs_);
    remove_flat(mesh);
    return counts_;
}

}  // namespace sunfleck::engine
