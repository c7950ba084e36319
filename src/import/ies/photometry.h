// Photometry: the measured intensities of a luminaire, from an IES file (ANSI/IES LM-63).
//
// In:  the text of a file of 1986 to 2019, of photometric type C; TILT's factors, which are for
// lamps
//      that stand otherwise than they were measured, are read over.
// Out: candela by two angles, linear between those that were measured.
#pragma once

#include "math/vector.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

class Photometry {
public:
    /// @param name  of the file, for messages.
    /// @throws Error  for what is no such file, is cut short, or cannot be.
    Photometry(const std::string& text, const std::string& name);

    /// Returns the intensity in candela; zero beyond the vertical angles that were measured.
    /// @param vertical  degrees from the nadir, 0 to 180.
    /// @param horizontal  degrees around it, 0 to 360.
    double candela(double vertical, double horizontal) const;

    /// Returns the same by a unit vector: the nadir is -z, horizontal angles go from x over y.
    double candela(const Vec3d& w) const;

private:
    /// Returns the horizontal angle within those that were measured, by the luminaire's symmetry.
    double measured_angle(double horizontal) const;

    std::vector<double> verticals_;    // increasing
    std::vector<double> horizontals_;  // increasing
    std::vector<double> candela_;      // for each horizontal angle all vertical ones
};

}  // namespace sunfleck::engine
