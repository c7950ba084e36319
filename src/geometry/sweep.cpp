// Azimuths.
#include "geometry/sweep.h"

#include <cmath>

namespace sunfleck::engine {

float azimuth(double x, double y) {
    const float angle = std::atan2(static_cast<float>(y), static_cast<float>(x));
    return angle < 0 ? angle + 2 * kPi : angle;
}

}  // namespace sunfleck::engine
