// The alpha test inside Embree: hits on surfaces that are there in part are kept or passed over.
#pragma once

#include "geometry/complete_hit.h"
#include "geometry/query.h"

#include <cstdint>

namespace sunfleck::engine {

/// Is the surface there where a query's ray meets it? Always, without an alpha test.
/// @param crossing  tells apart the points where a ray meets one primitive several times.
bool is_there(const Found& found, const Query& query, std::uint32_t geometry,
              std::uint32_t crossing);

/// Makes Embree ask is_there() for each hit on the mesh, whose place in memory must last.
void attach_cover(const BuiltShape& mesh);

}  // namespace sunfleck::engine
