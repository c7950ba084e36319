// What each named material is made of.
#pragma once

#include "material/material.h"

#include <optional>
#include <string_view>

namespace sunfleck::engine {

enum class MaterialFamily { glass, metal, plastic, matt };

/// As the user writes it.
std::string_view name_of(MaterialFamily family);

struct MaterialName {
    std::string_view name;
    MaterialFamily family;
    std::string_view what;
    std::string_view source;  // of its numbers
};

struct NamedMaterial {
    Material material;
    bool is_clear = false;  // glass: light passes
    /// Of the inside, per metre; absent where it is clear over metres, and for what is opaque.
    std::optional<Spectrum> absorption{};
};

/// What a user says beside a name.
struct MaterialWishes {
    std::optional<float> roughness{};
    std::optional<Vec3> colour{};
};

/// Returns the material of a row of material_names().
NamedMaterial material_of(const MaterialName& row, const MaterialWishes& wishes);

}  // namespace sunfleck::engine
