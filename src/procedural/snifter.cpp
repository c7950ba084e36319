// The snifter's curves, from the middle of the foot's underside over the rim down to the brandy.

#include "procedural/snifter.h"

#include <array>

namespace sunfleck::engine {
namespace {

/// Each piece begins in the direction in which the previous one ends.
constexpr std::array<CurvePiece, 8> kWall = {{
    {{{{0, 0.3}, {1.5, 0.3}, {2.3, 0.01}, {3.1, 0.01}}}, 10},       // the hollow underside
    {{{{3.1, 0.01}, {3.3, 0.01}, {3.42, 0.06}, {3.42, 0.14}}}, 6},  // the foot's edge
    {{{{3.42, 0.14}, {3.42, 0.22}, {3.35, 0.25}, {3.22, 0.27}}}, 6},
    {{{{3.22, 0.27}, {1.92, 0.47}, {0.45, 0.6}, {0.45, 2.4}}}, 20},  // up to the stem
    {{{{0.45, 2.4}, {0.45, 4.15}, {4.5, 4}, {4.5, 7.6}}}, 64},       // the bowl
    {{{{4.5, 7.6}, {4.5, 10.1}, {3.3, 11.7}, {2.95, 13.4}}}, 64},
    {{{{2.95, 13.4}, {2.934, 13.478}, {2.854, 13.478}, {2.838, 13.4}}}, 8},  // the rim
    {{{{2.838, 13.4}, {3.188, 11.7}, {4.36, 10.1}, {4.36, 7.6}}}, 64},       // the inside
}};

constexpr ProfileCurve kBottom = {{{4.36, 7.6}, {4.36, 5.15}, {2.5, 4.75}, {0, 4.75}}};

}  // namespace

GlassCurves snifter_curves() {
    return {kWall, kBottom, 0.05};
}

}  // namespace sunfleck::engine
