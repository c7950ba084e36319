// A picture of few pixels at the size of one of many.
#pragma once

#include "image/picture.h"

namespace sunfleck::engine {

/// Returns a picture of that size; each of its pixels is the small picture's at that place.
/// @param width  and height: in pixels, those of the small picture or more.
Picture enlarged(const Picture& small, int width, int height);

}  // namespace sunfleck::engine
