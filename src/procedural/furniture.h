// Furniture: each piece is centred at the origin, its feet on z = 0, its front towards -y. Unit:
// metres.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <cstdint>

namespace sunfleck::engine {

/// A piece whose upholstery and woodwork have different materials.
struct Seat {
    Mesh cloth;
    Mesh wood;
};

/// @param places  number of cushions, each 62 cm wide.
Seat sofa(int places);

/// Returns a low round table on three turned legs, 44 cm high.
Mesh round_table();

/// Returns shelves with two sides, five boards and a back; 1.2 m wide, 2 m high.
Mesh shelves();
/// Returns books for the shelves. @param kind  0, 1 or 2: every third book.
Mesh books(int kind);

/// Returns a lamp on a stem, 1.5 m high.
Mesh lamp_stem();
Mesh lamp_shade();

/// Returns a pot; plant leaves are separate.
Mesh pot();
Mesh leaves();

/// Returns a hollow bowl, 34 cm wide; the fruit in it is separate.
Mesh bowl();
Mesh fruit();

/// Returns a folded curtain from the origin along x. @param width  of it. @param height  of its
/// rail.
Mesh folded_curtain(double width, double height);

/// Returns a single-layer net in shallow folds, placed as folded_curtain().
Mesh net_curtain(double width, double height);

}  // namespace sunfleck::engine
