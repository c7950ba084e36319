// Layers of a picture as a page gets them: the picture itself and each AOV, in 16-bit numbers.
//
// The numbers are the upper halves of floats ("bfloat16"): as bright as a sun may be, and as dark
// as its shadow, to 1 part in 256. Half floats end at 65,504.
#pragma once

#include "image/picture.h"

#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// The layer of the light that is in no light group: no AOV has such a name.
inline constexpr std::string_view kRestOfLight = "rest of light";

struct LiveLayer {
    std::string name;  // "picture", or an AOV's: "caustic", "error"
    std::vector<const Channel*> channels;
};

/// Returns the layers in the order of their first channels, which stand as R, G, B or X, Y, Z; they
/// point into the picture. IDs of a Cryptomatte are nothing to look at, and no layer.
std::vector<LiveLayer> layers_of(const Picture& picture);

/// Returns the values of one channel after the other, little-endian, rounded to the nearest.
std::string layer_bytes(const LiveLayer& layer);

}  // namespace sunfleck::engine
