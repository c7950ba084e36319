// The output transform: from the light of a picture to the sRGB values of a .png or .jpg.
//
// In: channels R, G, B of linear sRGB. Out: encoded values in [0,1]. In this order: exposure,
// glare, vignette, white balance, tone curve, sRGB encoding.
#pragma once

#include "image/picture.h"
#include "image/tone.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Stops of exposure, up or down.
inline constexpr double kMostExposure = 100;

struct OutputTransform {
    float exposure = 0;                     // stops
    std::optional<double> white_balance{};  // kelvin of the light that becomes white
    Tone tone = Tone::none;
    double glare = 0;     // fraction of the light that is scattered (glare.h)
    double vignette = 0;  // stops by which the corners are darker
};

/// Returns the sRGB values, pixel by pixel, row by row from the top. What is below black or above
/// white after all steps is cut by the encoding.
/// @param path  name of the file, for the Error.
/// @throws Error  for a picture without R, G, B, and for one with light that is not finite where
/// glare would spread it.
std::vector<float> screen_values(const Picture& picture, const OutputTransform& transform,
                                 const std::string& path);

}  // namespace sunfleck::engine
