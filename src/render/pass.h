// One pass of the renderer, as a pure function.
//
// In:  scene, settings, seed and number of the pass. Out: the image of this pass alone, unbiased
// for its radius, and integer counts. So passes may run in any order, on any machine, or again:
// the film only adds them up.
#pragma once

#include "eye/eye_pass.h"
#include "render/epoch.h"

namespace sunfleck {

/// Seconds.
struct PassTimes {
    double build = 0;  // the scene at the pass's wavelengths
    double eye = 0;
    double index = 0;
    double photon = 0;  // tracing and deposits
    double learn = 0;   // pilots and trials

    PassTimes& operator+=(const PassTimes& other) {
        build += other.build;
        eye += other.eye;
        index += other.index;
        photon += other.photon;
        learn += other.learn;
        return *this;
    }
};

struct PassResult {
    PassImage image;
    Statistics statistics;
    PassTimes seconds;
    double radius_factor = 1;
    double visible_fraction = 0;      // this pass's estimate, of uniform paths from all lights
    std::vector<GroupCounts> groups;  // as the epoch's
    std::uint32_t draws = 1;
    std::uint32_t weight = 1;  // how often it counts in the picture
};

/// The pixels that the scene's film renders.
PixelWindow window_of(const FilmDescription& film);

/// @param epoch  of that pass.
PassResult render_pass(const Scene& scene, const RenderSettings& settings, std::uint32_t number,
                       const Epoch& epoch);

/// The same, learning the epoch by itself.
inline PassResult render_pass(const Scene& scene, const RenderSettings& settings,
                              std::uint32_t number) {
    return render_pass(scene, settings, number, learn_epoch(scene, settings, number));
}

}  // namespace sunfleck
