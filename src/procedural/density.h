// Densities of media in space: smooth noise, and the statement of a grid of densities.
#pragma once

#include "math/vector.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace sunfleck::engine {

/// Returns a smooth function of place, from -1 to 1, whose features are about one unit wide: random
/// numbers at whole coordinates, joined by polynomials. Only + - * and floor are used, so that bits
/// are the same on every machine.
/// @param seed  selects one of many such functions.
double smooth_noise(const Vec3d& p, std::uint32_t seed);

/// Returns a sum of such functions, each of half the width and half the size of the one before.
double smooth_noise(const Vec3d& p, std::uint32_t seed, int octaves);

/// Returns three independent functions as a vector.
Vec3d smooth_noise_vector(const Vec3d& p, std::uint32_t seed, int octaves);

/// Returns 0 below `low`, 1 above `high`, and a smooth step between. low > high turns it round.
double smooth_step(double low, double high, double x);

/// A box cut into equal cells. The density is sampled at their centres.
struct DensityBox {
    Vec3d low;
    Vec3d high;
    std::array<int, 3> cells;
};

/// Returns the parameters of a `uniformgrid` medium that describe its density: whole numbers from 0
/// to 100, for a density of 0 to 1. The medium's `scale` holds the factor 1/100.
std::string density_text(const DensityBox& box, const std::function<double(const Vec3d&)>& density);

}  // namespace sunfleck::engine
