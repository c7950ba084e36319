// What each named material is made of.
#pragma once

#include "material/named_materials.h"

namespace sunfleck::engine {

/// What a user says beside a name.
struct MaterialWishes {
    std::optional<float> roughness{};
    std::optional<Vec3> colour{};
};

/// Returns the material of a row of material_names().
NamedMaterial material_of(const MaterialName& row, const MaterialWishes& wishes);

}  // namespace sunfleck::engine
