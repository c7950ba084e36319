// IDs of all names at once, so that none is hashed for each ray.
#include "mattes/scene_ids.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

std::vector<MatteId> ids_of(const std::vector<std::string>& names) {
    std::vector<MatteId> ids;
    ids.reserve(names.size());
    for (const std::string& name : names)
        ids.push_back(name.empty() ? kNoMatteId : matte_id(as_utf8(name)));
    return ids;
}

}  // namespace

SceneIds::SceneIds(const Scene& scene, MatteKind kind) : scene_(scene), kind_(kind) {
    const SceneNames& names = scene.names();
    if (kind == MatteKind::material) {
        materials_ = ids_of(names.materials);
        return;
    }
    shapes_ = ids_of(names.shapes);
    instances_ = ids_of(names.instances);
    for (const auto& parts : names.parts)
        parts_.push_back(parts ? ids_of(parts->all) : std::vector<MatteId>());
}

MatteId SceneIds::at(const Hit& hit) const {
    if (kind_ == MatteKind::material) return materials_[scene_.material_of(hit)];
    if (hit.instance != kNone && instances_[hit.instance] != kNoMatteId)
        return instances_[hit.instance];
    if (const PartNames* parts = scene_.names().parts[hit.shape].get())
        return parts_[hit.shape][parts->of_primitive[hit.primitive]];
    return shapes_[hit.shape];
}

Manifest SceneIds::names_of(const std::vector<MatteId>& ids) const {
    Manifest manifest;
    const auto add = [&](const std::vector<std::string>& names, const std::vector<MatteId>& of) {
        for (std::size_t i = 0; i < of.size(); ++i)
            if (std::binary_search(ids.begin(), ids.end(), of[i]))
                manifest.try_emplace(as_utf8(names[i]), of[i]);
    };
    const SceneNames& names = scene_.names();
    add(names.materials, materials_);
    add(names.shapes, shapes_);
    add(names.instances, instances_);
    for (std::size_t i = 0; i < parts_.size(); ++i)
        if (names.parts[i]) add(names.parts[i]->all, parts_[i]);
    return manifest;
}

}  // namespace sunfleck::engine
