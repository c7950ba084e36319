// The parts of a pocket watch, each in its place.
//
// Unit: millimetres. The middle of the dial is above the origin, 12 o'clock is towards +y, the
// crown towards +x, the hinge of the lid towards -x; the case lies on z = 0.
#pragma once

#include "procedural/mesh.h"

namespace sunfleck::engine {

Mesh watch_case();
/// A hollow bowl, concave towards the dial, standing open at its hinge.
Mesh watch_lid();
/// A closed shell; its rim is within the case.
Mesh watch_cover();
/// Hinge, stem, crown and bow.
Mesh watch_fittings();
Mesh watch_chain();

Mesh watch_dial();
/// Raised Roman numerals, minutes and rings. Strokes that cross differ in height by 0.02 mm.
Mesh watch_marks();
Mesh watch_hands();

}  // namespace sunfleck::engine
