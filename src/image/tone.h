// Tone curves: linear light of any size to light that a screen can show, in [0,1].
//
// Each curve is data and one function of a number: a matrix, the function of each channel, a
// second matrix, a power. Rows of the matrices sum to one, so grey stays grey.
// Sources and numbers: docs/reference/pictures.md.
#pragma once

#include "core/named_rows.h"
#include "math/colour_matrix.h"
#include "math/vector.h"

#include <array>
#include <string_view>

namespace sunfleck::engine {

enum class Tone { none, filmic, aces, agx };

inline constexpr std::array<ChoiceRow<Tone>, 4> kTones = {{
    {Tone::none, "none", "light above white is cut"},
    {Tone::filmic, "filmic", "Hable's curve"},
    {Tone::aces, "aces", "Hill's fit of the ACES reference"},
    {Tone::agx, "agx", "Sobotka's AgX; bright colours tend to white"},
}};

struct ToneCurve {
    Rows in;                          // linear sRGB to the channels of the curve
    Rows out;                         // and back
    double white = 1;                 // the least light of a channel that becomes 1
    double (*value)(double light){};  // increasing from 0 to 1, for light in (0, white)
    double decoding = 1;              // power by which what comes out becomes light
};

/// Returns the curve of a tone; that of `none` is the light itself.
const ToneCurve& tone_curve(Tone tone);

/// Returns light that a screen can show, in [0,1]. Channels below 0 and NaN count as 0, those
/// above the curve's white as white. What the second matrix takes out of [0,1], colours beyond
/// sRGB, is cut there.
/// @param light  linear sRGB.
Vec3 toned(Tone tone, const Vec3& light);

}  // namespace sunfleck::engine
