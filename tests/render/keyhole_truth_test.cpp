// What is known of the keyhole scenes, worked out again by plain sums.
#include "support/keyhole_truth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using testing_support::keyhole_truth;
using testing_support::KeyholeTruth;

/// The middle of cell i of n of an interval around zero.
double cell(int i, int n, double width) {
    return ((i + 0.5) / n - 0.5) * width;
}

/// The mean over n x n cells of a square.
template <class F>
double mean_over_cells(double width, int n, const F& f) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += f(cell(i, n, width), cell(j, n, width));
    return sum / (n * n);
}

/// The mean over a square; the error of n x n cells, by that of 3 n x 3 n, is taken off.
template <class F>
double mean_over(double width, int n, const F& f) {
    return (9 * mean_over_cells(width, 3 * n, f) - mean_over_cells(width, n, f)) / 8;
}

/// Numbers as the scene file has them, not as the product has.
constexpr double kView = 2 * 0.5 * 0.41421356237309503;  // wide: the tangent of 22.5 degrees
constexpr double kDrop = 0.8;                            // from the pane to the floor

/// Mean irradiance of the view for flux one that leaves the pane at (x, y) from its middle:
/// cos^2 / (pi distance^2), over places of the view.
double irradiance_from(double x, double y) {
    return mean_over(kView, 5, [&](double u, double v) {
        const double distance2 = (u - x) * (u - x) + (v - y) * (v - y) + kDrop * kDrop;
        return kDrop * kDrop / (distance2 * distance2) / kPiDouble;
    });
}

/// Mean irradiance of the view, in units of the light's strength.
double mean_irradiance(const Keyhole& keyhole) {
    const double hole = keyhole.width;
    if (keyhole.light == KeyholeLight::sun)
        return 0.8 * hole * hole * 0.8 * mean_over(hole, 2, irradiance_from);
    // The lamp's middle is 2.8 m up the way (0.6, 0, -0.8); the pane 3.2 m below the roof.
    return 0.8 * 0.1 * 0.1 * hole * hole * mean_over(0.1, 2, [&](double lamp_x, double lamp_y) {
               return mean_over(hole, 1, [&](double x, double y) {
                   const double way_x = x - (lamp_x - 1.68);
                   const double way_y = y - lamp_y;
                   const double distance2 = way_x * way_x + way_y * way_y + 2.24 * 2.24;
                   const double further = 3.2 / 2.24;
                   return 2.24 * 2.24 / (distance2 * distance2) *
                          irradiance_from(x + further * way_x - 2.4, y + further * way_y);
               });
           });
}

// Seen: 1e-5 at most, the error of the sums.
TEST(KeyholeTruth, agrees_with_plain_sums) {
    for (const Keyhole& keyhole : kKeyholes) {
        SCOPED_TRACE(keyhole.name);
        const KeyholeTruth truth = keyhole_truth(keyhole);
        const double irradiance = mean_irradiance(keyhole);
        const double luminance = keyhole.strength * 0.5 / kPiDouble * irradiance;
        EXPECT_NEAR(truth.luminance, luminance, 1e-4 * luminance);
        const double box = 4.2 * 4.2 + 2.4 * 2.4 + 4 * 4;  // the square of its diagonal
        const double power =
            keyhole.light == KeyholeLight::sun ? kPiDouble * box / 4 : kPiDouble * 0.1 * 0.1;
        const double fraction = irradiance * kView * kView / power;
        EXPECT_NEAR(truth.visible_fraction, fraction, 1e-4 * fraction);
    }
}

TEST(KeyholeTruth, fractions_are_as_named) {
    for (std::size_t i = 0; i < kKeyholes.size(); ++i) {
        const double named = std::array<double, 5>{1e-4, 1e-6, 1e-8, 1e-9, 1e-6}.at(i);
        EXPECT_NEAR(keyhole_truth(kKeyholes.at(i)).visible_fraction, named, 0.05 * named);
    }
}

TEST(KeyholeTruth, pictures_are_equally_bright) {
    for (const Keyhole& keyhole : kKeyholes)
        EXPECT_NEAR(keyhole_truth(keyhole).luminance, 0.459, 0.015 * 0.459) << keyhole.name;
}

}  // namespace
}  // namespace sunfleck::engine
