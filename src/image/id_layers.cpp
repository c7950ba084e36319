// A matte's layers have its name and two digits.
#include "image/id_layers.h"

#include "sunfleck/error.h"

#include <algorithm>
#include <string_view>

namespace sunfleck::engine {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns whether the layer is one of the matte, or its preview.
bool is_of_matte(std::string_view layer, std::string_view matte) {
    if (!layer.starts_with(matte)) return false;
    const std::string_view rank = layer.substr(matte.size());
    return rank.empty() || (rank.size() == 2 && is_digit(rank[0]) && is_digit(rank[1]));
}

}  // namespace

bool holds_ids(const Picture& picture, const std::string& layer) {
    return std::any_of(picture.metadata.begin(), picture.metadata.end(), [&](const auto& entry) {
        const auto& [key, text] = entry;
        return key.starts_with("cryptomatte/") && key.ends_with("/name") &&
               is_of_matte(layer, text);
    });
}

void check_ids_kept(const Picture& picture, const ExrOptions& options) {
    if (is_exact(options.compression)) return;
    for (const Channel& channel : picture.channels)
        if (holds_ids(picture, exr_layer(channel.name)))
            throw Error({"--exr-compression"}, "dwaa and dwab would change the IDs of mattes",
                        "use zip or piz");
}

bool is_exact(ExrCompression compression) {
    return compression != ExrCompression::dwaa && compression != ExrCompression::dwab;
}

}  // namespace sunfleck::engine
