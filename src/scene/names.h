// SceneNames: the names of a scene's objects and materials, by which mattes tell them apart.
#pragma once

#include "geometry/ray.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Names of the parts of one shape.
struct PartNames {
    std::vector<std::string> all;
    std::vector<std::uint32_t> of_primitive;  // index into `all`, by Hit::primitive
};

/// Names are those of the scene file, in its bytes; none is empty. Things of one name are one
/// thing.
struct SceneNames {
    std::vector<std::string> materials;                   // by index of the material
    std::vector<std::string> shapes;                      // by Hit::shape
    std::vector<std::shared_ptr<const PartNames>> parts;  // by Hit::shape; null: it has none
    std::vector<std::string> instances;                   // by Hit::instance; empty: its shapes'

    /// Returns the name of the object at a hit: of its instance, of its part, or of its shape.
    const std::string& object_at(const Hit& hit) const {
        if (hit.instance != kNone && !instances[hit.instance].empty())
            return instances[hit.instance];
        if (const PartNames* named = parts[hit.shape].get())
            return named->all[named->of_primitive[hit.primitive]];
        return shapes[hit.shape];
    }
};

}  // namespace sunfleck::engine
