// What a page says of a render, as a line of JSON.
#pragma once

#include "image/picture.h"
#include "render/render_hooks.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

enum class LiveStage { reading, learning, rendering, ended };

struct LiveStatus {
    LiveStage stage = LiveStage::reading;
    std::string scene;
    Progress progress;
    int width = 0;  // of the whole picture; zero before the scene is read
    int height = 0;
    std::uint64_t picture = 0;        // its number; zero: none yet
    bool is_preview = false;          // the picture is one before the first pass
    std::vector<std::string> layers;  // of the picture
    double exposure = 0;              // stops that the .png has, or would have
    std::vector<std::string> warnings;
};

std::string status_json(const LiveStatus& status);

}  // namespace sunfleck::engine
