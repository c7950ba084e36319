// What mattes there are: of objects, of materials.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class MatteKind { object, material };

struct MatteKindRow {
    std::string_view name;
    MatteKind kind = MatteKind::object;
    std::string_view layer;  // in an .exr; the first of its ranks is this and "00"
};

/// By kind, in its order.
inline constexpr std::array<MatteKindRow, 2> kMatteKinds = {
    {{"object", MatteKind::object, "CryptoObject"},
     {"material", MatteKind::material, "CryptoMaterial"}}};

/// Returns the layer of a kind.
constexpr std::string_view layer_of(MatteKind kind) {
    return kMatteKinds.at(static_cast<std::size_t>(kind)).layer;
}

/// IDs of a pixel, two in each layer: what the specification suggests.
inline constexpr std::size_t kMatteIds = 6;

}  // namespace sunfleck::engine
