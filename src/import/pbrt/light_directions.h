// The direction of a light that has "from" and "to".
#pragma once

#include "import/pbrt/parameters.h"

namespace sunfleck::engine {

/// Returns the unit vector from "from" to "to" in the world.
/// @throws Error  if they are the same point.
inline Vec3d direction_of(const Statement& statement, const Matrix& to_world) {
    const Vec3d way = statement.point("to", {0, 0, 1}) - statement.point("from", {0, 0, 0});
    Vec3d direction;
    to_world.multDirMatrix(way, direction);
    const double length = direction.length();
    if (!(length > 0))
        throw Error(statement.where, "\"from\" and \"to\" of the light are the same point",
                    "move one of them");
    return direction / length;
}

}  // namespace sunfleck::engine
