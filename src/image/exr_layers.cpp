// Channels by the name before their last dot.
#include "image/exr_layers.h"

#include "image/exr_options.h"
#include "image/id_layers.h"

#include <algorithm>

namespace sunfleck::engine {

std::vector<ExrLayer> exr_layers(const Picture& picture) {
    std::vector<ExrLayer> layers;
    for (const Channel& channel : picture.channels) {
        const std::string name = exr_layer(channel.name);
        auto layer = std::find_if(layers.begin(), layers.end(),
                                  [&](const ExrLayer& known) { return known.name == name; });
        if (layer == layers.end())
            layer = layers.insert(layer, {name, {}, holds_ids(picture, name)});
        layer->channels.push_back(&channel);
    }
    return layers;
}

}  // namespace sunfleck::engine
