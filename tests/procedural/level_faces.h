// Faces in planes across the axes: do any two share some area? Light may then meet either.
#pragma once

#include "mesh_checks.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A triangle in a plane across an axis, seen along it.
struct Flat {
    std::array<Vec2d, 3> corners;
    double low = 0;  // of its first coordinate
    double high = 0;
};

/// Do two triangles share some area? One of their six edges parts them otherwise.
inline bool overlap(const Flat& a, const Flat& b) {
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2d& from = one->corners.at(i);
            const Vec2d way = one->corners.at((i + 1) % 3) - from;
            const double inside = way.cross(one->corners.at((i + 2) % 3) - from);
            const auto beyond = [&](const Vec2d& p) { return way.cross(p - from) / inside < 1e-4; };
            if (std::all_of(other->corners.begin(), other->corners.end(), beyond)) return false;
        }
    return true;
}

/// Triangles by the plane that they lie in, of those that lie across the axis.
inline std::map<float, std::vector<Flat>> level_faces(const std::vector<Mesh>& meshes,
                                                      std::size_t axis) {
    std::map<float, std::vector<Flat>> planes;
    for (const Mesh& mesh : meshes)
        for (const auto& t : mesh.triangles) {
            const std::array<std::array<float, 3>, 3> p = {mesh.points[t[0]], mesh.points[t[1]],
                                                           mesh.points[t[2]]};
            if (p[0].at(axis) != p[1].at(axis) || p[0].at(axis) != p[2].at(axis)) continue;
            Flat flat;
            for (std::size_t i = 0; i < 3; ++i)
                flat.corners.at(i) = {p.at(i).at((axis + 1) % 3), p.at(i).at((axis + 2) % 3)};
            flat.low = std::min({flat.corners[0].x, flat.corners[1].x, flat.corners[2].x});
            flat.high = std::max({flat.corners[0].x, flat.corners[1].x, flat.corners[2].x});
            planes[p[0].at(axis)].push_back(flat);
        }
    return planes;
}

/// Where the first such pair lies, in words; empty if there is none.
inline std::string doubled_face(const std::vector<Mesh>& meshes) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (auto& [place, flats] : level_faces(meshes, axis)) {
            std::sort(flats.begin(), flats.end(),
                      [](const Flat& a, const Flat& b) { return a.low < b.low; });
            for (std::size_t i = 0; i < flats.size(); ++i)
                for (std::size_t j = i + 1; j < flats.size() && flats[j].low < flats[i].high; ++j) {
                    if (!overlap(flats[i], flats[j])) continue;
                    std::ostringstream text;
                    text << "axis " << axis << " at " << place << ", near " << flats[j].corners[0];
                    return text.str();
                }
        }
    return {};
}

}  // namespace sunfleck::engine
