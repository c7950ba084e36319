// Adds the change of each light group, channel by channel.
#include "film/relight.h"

#include "film/film_picture.h"
#include "image/id_layers.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kRgb = "RGB";

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

Channel& channel_of(Picture& picture, const std::string& channel, const std::string& name) {
    for (Channel& one : picture.channels)
        if (one.name == channel) return one;
    throw Error({name}, "has no channel \"" + channel + "\"", "use a picture rendered by sunfleck");
}

void apply(const LightGroupFactor& factor, Picture& picture, const std::string& name) {
    for (std::size_t c = 0; c < kRgb.size(); ++c) {
        const float by = factor.rgb[static_cast<int>(c)];
        std::vector<float>& all = channel_of(picture, {kRgb[c]}, name).values;
        std::vector<float>& group = channel_of(picture, factor.name + "." + kRgb[c], name).values;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] += (by - 1) * group[i];
            group[i] *= by;
        }
    }
}

/// Returns whether the channel stays valid when lights change.
bool stays(const Picture& picture, const std::string& channel,
           const std::vector<std::string>& lights) {
    constexpr std::array<std::string_view, 3> kFeatures = {"albedo", "normal", "depth"};
    const std::size_t dot = channel.rfind('.');
    if (dot == std::string::npos) return true;  // R, G, B
    const std::string group = channel.substr(0, dot);
    return holds_ids(picture, group) ||
           std::find(lights.begin(), lights.end(), group) != lights.end() ||
           std::find(kFeatures.begin(), kFeatures.end(), group) != kFeatures.end();
}

}  // namespace

std::vector<std::string> light_groups_of(const Picture& picture) {
    const auto found = picture.metadata.find(kLightGroupNames);
    std::istringstream names(found == picture.metadata.end() ? std::string() : found->second);
    std::set<std::string> groups;
    for (std::string name; names >> name;) groups.insert(name);
    return {groups.begin(), groups.end()};
}

Relit relit(const Picture& picture, const std::vector<LightGroupFactor>& factors,
            const std::string& name) {
    const std::vector<std::string> lights = light_groups_of(picture);
    if (lights.empty())
        throw Error({name}, "has no light groups", "render it with --light-group, as .exr");
    Relit result{picture, {}};
    std::set<std::string> named;
    for (const LightGroupFactor& factor : factors) {
        if (std::find(lights.begin(), lights.end(), factor.name) == lights.end())
            throw Error({name}, "has no light group \"" + factor.name + "\"",
                        "use some of " + joined(lights));
        if (!named.insert(factor.name).second)
            throw Error({name}, "the light group \"" + factor.name + "\" is named twice",
                        "name each once");
        apply(factor, result.picture, name);
    }
    std::set<std::string> left_out;
    std::erase_if(result.picture.channels, [&](const Channel& channel) {
        if (stays(picture, channel.name, lights)) return false;
        left_out.insert(channel.name.substr(0, channel.name.rfind('.')));
        return true;
    });
    result.left_out.assign(left_out.begin(), left_out.end());
    return result;
}

Picture rest_of_light(const Picture& picture) {
    std::vector<LightGroupFactor> dark;
    for (const std::string& group : light_groups_of(picture)) dark.push_back({group, Vec3(0)});
    Picture rest = dark.empty() ? picture : relit(picture, dark, "the picture").picture;
    std::erase_if(rest.channels,
                  [](const Channel& channel) { return kRgb.find(channel.name) == kRgb.npos; });
    return rest;
}

}  // namespace sunfleck::engine
