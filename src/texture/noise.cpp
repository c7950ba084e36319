// Perlin's noise.
#include "texture/noise.h"

#include <array>
#include <cstdint>

namespace sunfleck::engine {
namespace {

/// Perlin's permutation of 0..255.
constexpr std::array<std::uint8_t, 256> kShuffled = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

/// The sixteen gradients of a lattice point: towards the edges of a cube, four of them twice.
/// (pbrt-v4, followed here, and Perlin's program repeat different ones.)
constexpr std::array<std::array<float, 3>, 16> kSlopes = {{{1, 1, 0},
                                                           {-1, 1, 0},
                                                           {1, -1, 0},
                                                           {-1, -1, 0},
                                                           {1, 0, 1},
                                                           {-1, 0, 1},
                                                           {1, 0, -1},
                                                           {-1, 0, -1},
                                                           {0, 1, 1},
                                                           {0, -1, 1},
                                                           {0, 1, -1},
                                                           {0, -1, -1},
                                                           {1, 1, 0},
                                                           {-1, 1, 0},
                                                           {0, 1, -1},
                                                           {0, -1, -1}}};

unsigned shuffled(unsigned i) {
    return kShuffled[i & 255U];
}

/// Position along one axis: the cell, the fraction within it, and its smooth weight.
struct Axis {
    unsigned cell;
    float part;
    float weight;

    explicit Axis(float x) {
        constexpr float kFar = 0x1p30F;
        const float near = std::isfinite(x) ? std::fmod(x, kFar) : 0;
        const float low = std::floor(near);
        cell = static_cast<unsigned>(static_cast<int>(low));
        part = near - low;
        weight = part * part * part * (part * (part * 6 - 15) + 10);
    }
};

float mixed(float a, float b, float part) {
    return (1 - part) * a + part * b;
}

struct OctaveSum {
    float sum = 0;
    float next_strength = 1;  // amplitude of the octave that would follow
};

/// Returns the sum of part(noise) over the octaves.
template <class Part>
OctaveSum sum_of_octaves(const Vec3& p, const Octaves& octaves, const Part& part) {
    OctaveSum total;
    float frequency = 1;
    for (int i = 0; i < octaves.count; ++i) {
        total.sum += total.next_strength * part(noise(p * frequency));
        frequency *= 1.99F;
        total.next_strength *= octaves.roughness;
    }
    return total;
}

}  // namespace

float noise(const Vec3& p) {
    const Axis x(p.x);
    const Axis y(p.y);
    const Axis z(p.z);
    const auto corner = [&](unsigned i, unsigned j, unsigned k) {
        const unsigned hash = shuffled(shuffled(shuffled(x.cell + i) + ((y.cell + j) & 255U)) +
                                       ((z.cell + k) & 255U));
        const auto& slope = kSlopes[hash & 15U];
        return slope[0] * (x.part - static_cast<float>(i)) +
               slope[1] * (y.part - static_cast<float>(j)) +
               slope[2] * (z.part - static_cast<float>(k));
    };
    const auto along_x = [&](unsigned j, unsigned k) {
        return mixed(corner(0, j, k), corner(1, j, k), x.weight);
    };
    const float near = mixed(along_x(0, 0), along_x(1, 0), y.weight);
    const float far = mixed(along_x(0, 1), along_x(1, 1), y.weight);
    return mixed(near, far, z.weight);
}

float fbm(const Vec3& p, const Octaves& octaves) {
    return sum_of_octaves(p, octaves, [](float value) { return value; }).sum;
}

float turbulence(const Vec3& p, const Octaves& octaves) {
    const OctaveSum total = sum_of_octaves(p, octaves, [](float value) { return std::abs(value); });
    return total.sum + total.next_strength * 0.2F;
}

}  // namespace sunfleck::engine
