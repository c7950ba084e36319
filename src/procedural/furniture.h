// Furniture, each piece in front of the origin: its feet on z = 0, its front towards -y. Metres.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

#include <cstdint>

namespace sunfleck::engine {

/// What the upholstery and the woodwork of a piece are made of differs.
struct Seat {
    Mesh cloth;
    Mesh wood;
};

/// @param places  cushions side by side, each 62 cm wide.
Seat sofa(int places);

/// A low round table on three turned legs; its top is 44 cm high.
Mesh round_table();

/// Two sides, five boards, a back; 1.2 m wide, 2 m high.
Mesh shelves();
/// Books that stand on the shelves. @param kind  of 0, 1, 2: every third book.
Mesh books(int kind);

/// A lamp on a stem, 1.5 m high.
Mesh lamp_stem();
Mesh lamp_shade();

/// A pot, and the leaves of the plant in it.
Mesh pot();
Mesh leaves();

/// A bowl, hollow, 34 cm wide; and fruit in it.
Mesh bowl();
Mesh fruit();

/// A curtain in folds, from the origin along x. @param width  of it. @param height  of its rail.
Mesh folded_curtain(double width, double height);

/// A net of one layer, in shallow folds, as folded_curtain().
Mesh net_curtain(double width, double height);

}  // namespace sunfleck::engine
