// Texture coordinates that pbrt-v4's textures cannot say, given to meshes instead.
//
// A texture there scales and shifts the coordinates of its mesh. Where all textures of a surface
// turn them alike, or take the same second set, the mesh is written with those coordinates.
#pragma once

#include "scene/description.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

bool is_same(const Mapping& a, const Mapping& b);

/// Returns the mapping that all textures of a shape have, if pbrt-v4 cannot say it and nothing else
/// depends on the coordinates of the mesh: no bumps, no direction of roughness, no picture of
/// emission.
std::optional<Mapping> common_mapping(const ShapeDescription& shape,
                                      const std::vector<Material>& materials,
                                      const std::vector<BumpMap>& bump_maps);

/// Returns the coordinates of a mesh under a mapping of coordinates. @param mapping  not one of
/// places in space.
std::vector<Vec2> mapped_coordinates(const TriangleMesh& mesh, const Mapping& mapping);

}  // namespace sunfleck::engine
