// PassResult: image, statistics and times of one pass.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "photon_samplers/model.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Seconds of the stages of a pass.
struct PassTimes {
    double build = 0;  // the scene at the pass's wavelengths
    double camera = 0;
    double index = 0;
    double photon = 0;  // tracing and deposits
    double learn = 0;   // pilots and trials

    PassTimes& operator+=(const PassTimes& other) {
        build += other.build;
        camera += other.camera;
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
    double visible_fraction = 0;        // this pass's estimate, of uniform paths from all lights
    std::vector<StratumCounts> strata;  // as the epoch's
    IndirectLight indirect = IndirectLight::photons;  // as the epoch's
    std::vector<SamplerSum> sums{};
};

}  // namespace sunfleck::engine
