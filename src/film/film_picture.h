// The film as a picture: the mean over passes, layer by layer, and its error.
#pragma once

#include "film/film.h"
#include "image/picture.h"

namespace sunfleck {

/// Channels R, G, B, then those of each layer that the film has ("direct.R", "depth.Z", ...), and
/// from two complete rounds on "error.Y", the standard error of the pixel's luminance (from
/// complete rounds alone). Black without passes.
/// @param scale  factor of all light and its error; features (albedo, normal, depth) keep theirs.
Picture film_picture(const Film& film, double scale = 1);

}  // namespace sunfleck
