// SceneIds: the ID of what a ray hits, of one kind.
#pragma once

#include "mattes/manifest.h"
#include "mattes/matte_kinds.h"
#include "scene/scene.h"

#include <vector>

namespace sunfleck::engine {

/// Thread-safe. The scene must outlive it.
class SceneIds {
public:
    SceneIds(const Scene& scene, MatteKind kind);

    /// Returns the ID of the object or material at a hit.
    MatteId at(const Hit& hit) const;

    /// Returns the names of some IDs.
    /// @param ids  ascending, each once.
    Manifest names_of(const std::vector<MatteId>& ids) const;

private:
    const Scene& scene_;
    MatteKind kind_;
    // As in SceneNames. Only the first is filled for materials.
    std::vector<MatteId> materials_;
    std::vector<MatteId> shapes_;
    std::vector<MatteId> instances_;
    std::vector<std::vector<MatteId>> parts_;
};

}  // namespace sunfleck::engine
