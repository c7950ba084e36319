// Parts of a pocket watch in their positions.
//
// Unit: millimetres. The centre of the dial is above the origin, 12 o'clock is towards +y, the
// crown towards +x, the hinge of the lid towards -x; the case lies on z = 0.
#pragma once

#include "procedural/mesh.h"

namespace sunfleck::engine {

Mesh watch_case();
/// Returns a hollow bowl, concave towards the dial, open at its hinge.
Mesh watch_lid();
/// Returns a closed shell whose rim is within the case.
Mesh watch_cover();
/// Returns hinge, stem, crown and bow.
Mesh watch_fittings();
Mesh watch_chain();

Mesh watch_dial();
/// Returns raised Roman numerals, minutes and rings. Heights of crossing strokes differ by 0.02 mm.
Mesh watch_marks();
Mesh watch_hands();

}  // namespace sunfleck::engine
