// What a page says of a render, as a line of JSON.
#pragma once

#include "image/tone.h"
#include "live/wishes.h"
#include "render/render_hooks.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

enum class LiveStage { reading, learning, rendering, ended };

/// A picture that the board shows.
struct LivePicture {
    std::uint64_t number = 0;  // zero: none yet
    std::vector<std::string> layers{};
    std::vector<std::string> groups{};  // of lights
    bool is_preview = false;            // one before the first pass
};

/// What is looked at aside, while the render waits.
struct LiveLook {
    std::array<int, 4> region{};  // x0 x1 y0 y1 in pixels of the whole picture
    bool is_moved = false;        // by another camera
    std::string camera;           // that camera, as statements of pbrt
    Progress progress{};
    LivePicture picture{};
    std::string fault{};  // why there will be no picture; empty: there will be one
};

struct LiveStatus {
    LiveStage stage = LiveStage::reading;
    std::string scene;
    Progress progress;
    int width = 0;  // of the whole picture; zero before the scene is read
    int height = 0;
    LivePicture picture;
    double exposure = 0;          // stops that the .png has, or would have
    Tone tone = Tone::none;       // of the .png
    std::optional<Rows> balance;  // its white balance, on linear sRGB
    std::optional<double> nits;   // cd/m^2 of a pixel of 1
    LiveEnds ends;                // of the render
    bool can_be_steered = false;
    bool is_paused = false;
    bool has_lens = false;  // of the camera
    std::optional<LiveLook> look;
    std::string earlier;  // name of a picture to compare with
    LivePicture earlier_picture;
    std::vector<std::string> warnings;
};

std::string status_json(const LiveStatus& status);

}  // namespace sunfleck::engine
