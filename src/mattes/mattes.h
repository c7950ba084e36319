// Mattes: which objects and materials each pixel shows, and how much of it, as a Cryptomatte.
//
// In:  a scene with its view, and how many camera rays a pixel has. Out: channels and attributes of
// an .exr. They depend on nothing else: no pass, no light, no number of threads.
// Source: Friedman and Jones, Fully Automatic ID Mattes with Support for Motion Blur and
// Transparency (SIGGRAPH 2015 posters); Cryptomatte Specification 1.2.0.
#pragma once

#include "image/picture.h"
#include "mattes/matte_kinds.h"
#include "scene/scene.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::uint32_t kUsualMatteSamples = 64;

struct MatteSettings {
    std::vector<MatteKind> kinds;  // each once
    /// Camera rays of a pixel: a power of two, 16 at least.
    std::uint32_t samples = kUsualMatteSamples;
};

struct Mattes {
    std::vector<Channel> channels;
    std::map<std::string, std::string> metadata;
    std::size_t crowded =
        0;  // pixels with more IDs of a kind than kMatteIds: the least are left out
};

/// Returns the mattes of the scene's view. A ray sees the first surface that is no null interface;
/// holes of alpha let it pass, glass does not, media are ignored. The coverage of an ID is its
/// share of the rays, which are distributed as the absolute value of the pixel filter, and on the
/// lens.
Mattes make_mattes(const Scene& scene, const MatteSettings& settings);

/// Adds channels and attributes to a picture of the same view.
void add_mattes(const Mattes& mattes, Picture& picture);

}  // namespace sunfleck::engine
