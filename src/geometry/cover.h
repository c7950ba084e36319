// The alpha test within Embree's traversal: hits on surfaces with alpha are kept or ignored.
#pragma once

#include "geometry/complete_hit.h"
#include "geometry/query.h"

#include <cstdint>

namespace sunfleck::engine {

/// Returns whether the alpha test passes; always true if the query has none.
/// @param crossing  index among several hits of a ray with one primitive.
bool is_there(const Intersection& found, const Query& query, std::uint32_t geometry,
              std::uint32_t crossing);

/// Makes Embree call is_there() for each hit on the mesh, whose address must not change.
void attach_cover(const BuiltShape& mesh);

}  // namespace sunfleck::engine
