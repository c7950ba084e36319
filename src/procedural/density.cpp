// Smooth noise on a lattice, and grids of densities as text.

#include "procedural/density.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns a random number of [-1, 1) for a point of the lattice.
double lattice_value(const std::array<std::int64_t, 3>& place, std::uint32_t seed) {
    std::uint32_t state = seed * 2654435769U + 1;
    for (const std::int64_t coordinate : place) {
        state = (state ^ static_cast<std::uint32_t>(coordinate)) * 1664525U + 1013904223U;
        state ^= state >> 15U;
        state *= 2246822519U;
        state ^= state >> 13U;
    }
    return static_cast<double>(state >> 8U) / 8388608 - 1;
}

/// Rises from 0 to 1, with two derivatives that are zero at both ends.
double eased(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

double mixed(double a, double b, double t) {
    return a + (b - a) * t;
}

/// Returns the shortest decimals that give the same floats.
std::string point_text(const Vec3d& p) {
    std::string text = "[";
    for (int axis = 0; axis < 3; ++axis) {
        std::array<char, 32> buffer{};
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                       static_cast<float>(p[axis]));
        text += ' ';
        text.append(buffer.data(), end.ptr);
    }
    return text + " ]";
}

}  // namespace

double smooth_noise(const Vec3d& p, std::uint32_t seed) {
    std::array<std::int64_t, 3> low{};
    Vec3d within;
    for (int axis = 0; axis < 3; ++axis) {
        const double floor = std::floor(p[axis]);
        low.at(static_cast<std::size_t>(axis)) = static_cast<std::int64_t>(floor);
        within[axis] = eased(p[axis] - floor);
    }
    const auto along_x = [&](int y, int z) {
        return mixed(lattice_value({low[0], low[1] + y, low[2] + z}, seed),
                     lattice_value({low[0] + 1, low[1] + y, low[2] + z}, seed), within.x);
    };
    const auto along_y = [&](int z) { return mixed(along_x(0, z), along_x(1, z), within.y); };
    return mixed(along_y(0), along_y(1), within.z);
}

double smooth_noise(const Vec3d& p, std::uint32_t seed, int octaves) {
    double sum = 0;
    double size = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += size * smooth_noise(p * (1 / size), seed + static_cast<std::uint32_t>(octave));
        size /= 2;
    }
    return sum;
}

Vec3d smooth_noise_vector(const Vec3d& p, std::uint32_t seed, int octaves) {
    return {smooth_noise(p, seed, octaves), smooth_noise(p, seed + 100, octaves),
            smooth_noise(p, seed + 200, octaves)};
}

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

std::string density_text(const DensityBox& box,
                         const std::function<double(const Vec3d&)>& density) {
    const auto& [nx, ny, nz] = box.cells;
    std::string text = "    \"integer nx\" " + std::to_string(nx) + " \"integer ny\" " +
                       std::to_string(ny) + " \"integer nz\" " + std::to_string(nz) +
                       "\n    \"point3 p0\" " + point_text(box.low) + " \"point3 p1\" " +
                       point_text(box.high) + "\n    \"float density\" [";
    const Vec3d size = box.high - box.low;
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y) {
            text += '\n';
            for (int x = 0; x < nx; ++x) {
                const Vec3d centre =
                    box.low + Vec3d(size.x * (x + 0.5) / nx, size.y * (y + 0.5) / ny,
                                    size.z * (z + 0.5) / nz);
                const double value = std::clamp(density(centre), 0.0, 1.0);
                if (x > 0) text += ' ';
                text += std::to_string(std::lround(value * 100));
            }
        }
    return text + " ]\n";
}

}  // namespace sunfleck::engine
