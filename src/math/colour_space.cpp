// Matrices of colour spaces.
#include "math/colour_space.h"

#include "core/small_letters.h"
#include "math/colour_matrix.h"

#include <string>

namespace sunfleck::engine {
namespace {

struct Space {
    std::string_view name;
    std::array<double, 6> primaries;  // x and y of red, green, blue
    bool has_d65 = true;              // else the white of ACES
};

constexpr std::array<Space, 4> kSpaces = {
    {{"srgb", {0.64, 0.33, 0.3, 0.6, 0.15, 0.06}},
     {"dci-p3", {0.68, 0.32, 0.265, 0.69, 0.15, 0.06}},
     {"rec2020", {0.708, 0.292, 0.17, 0.797, 0.131, 0.046}},
     {"aces2065-1", {0.7347, 0.2653, 0, 1, 0.0001, -0.077}, false}}};

constexpr std::array<double, 2> kAcesWhite = {0.32168, 0.33767};

Triple white_of(const Space& space) {
    if (space.has_d65) return xyz_of_rgb({1, 1, 1});
    const auto [x, y] = kAcesWhite;
    return {x / y, 1, (1 - x - y) / y};
}

Triple xyz_of(const Space& space, const Triple& rgb) {
    Rows primaries{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = space.primaries.at(2 * i);
        const double y = space.primaries.at(2 * i + 1);
        primaries[0].at(i) = x;
        primaries[1].at(i) = y;
        primaries[2].at(i) = 1 - x - y;
    }
    return xyz_of_primaries(primaries, white_of(space)) * rgb;
}

const Space& entry(ColourSpace space) {
    return kSpaces.at(static_cast<std::size_t>(space));
}

}  // namespace

std::optional<ColourSpace> colour_space(std::string_view name) {
    const std::string small = small_letters(std::string(name));
    for (std::size_t i = 0; i < kSpaces.size(); ++i)
        if (kSpaces.at(i).name == small) return static_cast<ColourSpace>(i);
    return {};
}

Triple srgb_of_light(ColourSpace space, const Triple& rgb) {
    if (space == ColourSpace::srgb) return rgb;
    return rgb_of_xyz(xyz_of(entry(space), rgb));
}

Triple srgb_of_surface(ColourSpace space, const Triple& rgb) {
    if (entry(space).has_d65) return srgb_of_light(space, rgb);
    const Space& own = entry(space);
    return rgb_of_xyz(adapted(xyz_of(own, rgb), white_of(own), xyz_of_rgb({1, 1, 1})));
}

}  // namespace sunfleck::engine
