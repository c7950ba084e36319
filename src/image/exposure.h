// Exposure of a picture for a screen: stops that are given, or found from the picture.
#pragma once

#include "image/picture.h"
#include "image/picture_file.h"

namespace sunfleck::engine {

struct Exposure {
    bool is_automatic = false;
    double stops = 0;  // unless automatic
};

/// Returns the stops that show the picture's middle as middle grey, .18 of white: the mean of the
/// logarithms of luminance, over all pixels but those below a hundredth of the mean of what is lit;
/// in tenths of a stop.
double automatic_stops(const Picture& picture);

inline double stops_of(const Exposure& exposure, const Picture& picture) {
    return exposure.is_automatic ? automatic_stops(picture) : exposure.stops;
}

/// Returns the options with the exposure of this picture.
inline PictureFileOptions with_exposure(PictureFileOptions options, const Exposure& exposure,
                                        const Picture& picture) {
    options.transform.exposure = static_cast<float>(stops_of(exposure, picture));
    return options;
}

}  // namespace sunfleck::engine
