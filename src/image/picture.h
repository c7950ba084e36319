// Picture: named channels of floats, row by row from the top left.
//
// Channel names are those of OpenEXR: "R", "G", "B" for the picture itself, "direct.R" and so on
// for AOVs, "error.Y" for an AOV of one channel. Light is linear sRGB.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

struct Channel {
    std::string name;
    std::vector<float> values;  // width * height values, row by row from the top

    friend bool operator==(const Channel&, const Channel&) = default;
};

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;
    std::map<std::string, std::string> metadata;  // key to text, for formats that can store it
    float pixel_aspect = 1;                       // width of a pixel over its height

    friend bool operator==(const Picture&, const Picture&) = default;

    std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }

    /// Returns the channel of that name, or null.
    const Channel* find(std::string_view name) const {
        const auto found = std::find_if(channels.begin(), channels.end(),
                                        [&](const Channel& c) { return c.name == name; });
        return found == channels.end() ? nullptr : &*found;
    }

    /// Adds a channel of zeros. The reference is valid until the next add().
    Channel& add(std::string name) {
        channels.push_back({std::move(name), std::vector<float>(pixels())});
        return channels.back();
    }
};

}  // namespace sunfleck::engine
