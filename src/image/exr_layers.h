// The layers of a picture by the names of its channels.
#pragma once

#include "image/picture.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Channels of one layer.
struct ExrLayer {
    std::string name;  // exr_layer() of exr_options.h
    std::vector<const Channel*> channels;
    bool holds_ids = false;  // id_layers.h
};

/// Returns the layers in the order of their first channels; they point into the picture.
std::vector<ExrLayer> exr_layers(const Picture& picture);

}  // namespace sunfleck::engine
