// Perez's formula for luminance and chromaticities, texel by texel.

#include "procedural/sky.h"

#include "math/colour.h"
#include "math/warp.h"
#include "procedural/little_endian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr double kTurbidity = 3;
constexpr double kGround = 0.05;  // radiance of the lower half, per illuminance

/// Perez's five coefficients.
using Perez = std::array<double, 5>;

/// Linear in turbidity: slope and value at zero.
constexpr Perez at_turbidity(const Perez& slope, const Perez& zero) {
    Perez perez{};
    for (std::size_t i = 0; i < 5; ++i) perez.at(i) = slope.at(i) * kTurbidity + zero.at(i);
    return perez;
}

constexpr Perez kLuminance = at_turbidity({0.1787, -0.3554, -0.0227, 0.1206, -0.0670},
                                          {-1.4630, 0.4275, 5.3251, -2.5771, 0.3703});
constexpr Perez kChromaX = at_turbidity({-0.0193, -0.0665, -0.0004, -0.0641, -0.0033},
                                        {-0.2592, 0.0008, 0.2125, -0.8989, 0.0452});
constexpr Perez kChromaY = at_turbidity({-0.0167, -0.0950, -0.0079, -0.0441, -0.0109},
                                        {-0.2608, 0.0092, 0.2102, -1.6537, 0.0529});

/// Cubic in the sun's distance from the zenith (radians), quadratic in turbidity.
using Zenith = std::array<std::array<double, 4>, 3>;

constexpr Zenith kZenithX = {{{0, 0.00209, -0.00375, 0.00166},
                              {0.00394, -0.03202, 0.06377, -0.02903},
                              {0.25886, 0.06052, -0.21196, 0.11693}}};
constexpr Zenith kZenithY = {{{0, 0.00317, -0.00610, 0.00275},
                              {0.00516, -0.04153, 0.08970, -0.04214},
                              {0.26688, 0.06670, -0.26756, 0.15346}}};

double zenith(const Zenith& z, double angle) {
    return (horner(z[0], angle) * kTurbidity + horner(z[1], angle)) * kTurbidity +
           horner(z[2], angle);
}

double angle_between(double cosine) {
    return std::acos(static_cast<float>(std::clamp(cosine, -1.0, 1.0)));
}

double exponential(double x) {
    return std::exp(static_cast<float>(x));
}

/// @param height  cosine from the zenith. @param to_sun  cosine of the angle to the sun.
double perez(const Perez& p, double height, double to_sun) {
    return (1 + p[0] * exponential(p[1] / std::max(height, 0.01))) *
           (1 + p[2] * exponential(p[3] * angle_between(to_sun)) + p[4] * to_sun * to_sun);
}

/// Linear sRGB (D65) of chromaticities and luminance, without negative parts.
Triple srgb(double x, double y, double luminance) {
    Triple rgb = rgb_of_xyz({x / y * luminance, luminance, (1 - x - y) / y * luminance});
    for (double& channel : rgb) channel = std::max(0.0, channel);
    return rgb;
}

}  // namespace

std::string clear_sky_pfm(const Vec3d& sun, int side) {
    const double angle = angle_between(sun.z);
    const auto value = [&](const Perez& p, const Vec3d& w) {
        return perez(p, w.z, w.dot(sun)) / perez(p, 1, sun.z);
    };
    std::vector<Triple> texels;
    double illuminance = 0;
    for (int row = side - 1; row >= 0; --row)  // PFM has the lowest row first
        for (int column = 0; column < side; ++column) {
            const Vec3d w = uniform_sphere({(column + 0.5) / side, (row + 0.5) / side});
            if (w.z <= 0) {
                texels.push_back({-1, -1, -1});
                continue;
            }
            const double luminance = value(kLuminance, w);
            texels.push_back(srgb(zenith(kZenithX, angle) * value(kChromaX, w),
                                  zenith(kZenithY, angle) * value(kChromaY, w), luminance));
            illuminance += luminance * w.z * 4 * kPiDouble / side / side;
        }
    std::string bytes = "PF\n" + std::to_string(side) + ' ' + std::to_string(side) + "\n-1.0\n";
    for (const auto& texel : texels)
        for (const double channel : texel) {
            const double scaled = channel < 0 ? kGround : channel / illuminance;
            append_float(bytes, static_cast<float>(scaled));
        }
    return bytes;
}

}  // namespace sunfleck::engine
