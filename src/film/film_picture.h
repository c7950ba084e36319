// The film as a picture: the mean over passes, AOV by AOV, and its error. Passes of open batches
// count less or not at all (film.h).
#pragma once

#include "film/film.h"
#include "image/picture.h"

namespace sunfleck::engine {

/// Name of the metadata that says of a picture that its bias has been subtracted.
inline constexpr const char* kExtrapolated = "extrapolated";

/// Name of the metadata that names the light groups, with spaces between.
inline constexpr const char* kLightGroupNames = "light_groups";

struct FilmPictureOptions {
    bool extrapolate = false;  // subtract the bias, where it is known (film/bias.h)
};

/// Channels R, G, B, then those of each AOV that the film has ("direct.R", "depth.Z", ...), those
/// of lights last; from
/// two complete batches on "error.Y", the standard error of the pixel's luminance (from complete
/// batches alone, widened as error_bars.h says); and where the bias of the discs is known "bias.R",
/// "bias.G", "bias.B": what to subtract from RGB, or what has been subtracted. Then metadata say
/// so, the error is that of the difference, and AOVs are as they were: they add up to RGB and
/// bias. Black without passes.
Picture film_picture(const Film& film, FilmPictureOptions options = {});

}  // namespace sunfleck::engine
