// One name where all triangles of a shape have the same.
#include "import/part/names.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace sunfleck::engine {

PartObjects::PartObjects(const ObjMesh& mesh, const std::string& path) : names_(mesh.objects) {
    const auto nameless = static_cast<std::uint32_t>(names_.size());
    const std::string stem = std::filesystem::path(path).stem().string();
    names_.push_back(stem.empty() ? "part" : stem);
    if (nameless == 0) return;
    of_triangle_.assign(mesh.triangles.size(), nameless);
    for (std::size_t r = 0; r < mesh.runs.size(); ++r) {
        const std::size_t end =
            r + 1 < mesh.runs.size() ? mesh.runs[r + 1].first : mesh.triangles.size();
        for (std::size_t t = mesh.runs[r].first; t < end; ++t)
            if (mesh.runs[r].object != kNoIndex) of_triangle_[t] = mesh.runs[r].object;
    }
}

void PartObjects::name(ShapeDescription& shape, std::span<const std::uint32_t> triangles) const {
    shape.name = names_.back();
    if (of_triangle_.empty() || triangles.empty()) return;
    const std::uint32_t first = of_triangle_[triangles[0]];
    shape.name = names_[first];
    if (std::all_of(triangles.begin(), triangles.end(),
                    [&](std::uint32_t t) { return of_triangle_[t] == first; }))
        return;
    PartNames parts;
    parts.of_primitive.reserve(triangles.size());
    std::map<std::uint32_t, std::uint32_t> numbers;  // of the names that the shape has
    for (const std::uint32_t t : triangles) {
        const auto [place, is_new] =
            numbers.try_emplace(of_triangle_[t], static_cast<std::uint32_t>(parts.all.size()));
        if (is_new) parts.all.push_back(names_[of_triangle_[t]]);
        parts.of_primitive.push_back(place->second);
    }
    shape.parts = std::make_shared<const PartNames>(std::move(parts));
}

}  // namespace sunfleck::engine
