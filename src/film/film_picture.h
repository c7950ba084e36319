// The picture of a film: the mean over passes for each AOV, and its error. Passes of open batches
// have reduced shares, or none (film.h).
#pragma once

#include "film/film.h"
#include "image/picture.h"

namespace sunfleck::engine {

/// Metadata key of pictures whose bias has been subtracted.
inline constexpr const char* kExtrapolated = "extrapolated";

/// Metadata key of the names of light groups, separated by spaces.
inline constexpr const char* kLightGroupNames = "light_groups";

struct FilmPictureOptions {
    bool extrapolate = false;  // subtract the bias where it is known (film/bias.h)
};

/// Returns channels R, G, B, then those of each AOV of the film ("direct.R", "depth.Z", ...), light
/// groups last. With two or more complete batches there is "error.Y", the standard error of the
/// pixel's luminance (from complete batches alone, widened as in error_bars.h). Where the bias of
/// the gather radius is known, "bias.R", "bias.G", "bias.B" are what to subtract from RGB, or what
/// has been subtracted. In the latter case metadata say so, the error is that of the difference,
/// and AOVs are unchanged: they add up to RGB plus bias. Without passes the picture is black.
/// Metadata are those of film_metadata.h, too.
Picture film_picture(const Film& film, FilmPictureOptions options = {});

}  // namespace sunfleck::engine
