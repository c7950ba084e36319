// Values as samples at the centres of voxels.
#include "import/pbrt/medium_voxels.h"

#include "import/pbrt/words.h"
#include "medium/density_samples.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Above, products with coefficients and distances leave floats.
constexpr double kMostDensity = 1e18;

Voxel counts_of(const Statement& medium) {
    Voxel counts{};
    const std::array<std::string_view, 3> names = {"nx", "ny", "nz"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        counts[axis] = medium.integer(names[axis]).value_or(1);
        if (counts[axis] < 1)
            throw Error(place_of(medium, names[axis]), in_quotes(names[axis]) + " is less than 1",
                        "give the number of voxels along that axis");
    }
    return counts;
}

/// @param each  numbers of a value. @throws Error  unless there is a value for each voxel.
void check_voxels(const Parameter& values, std::size_t each, const Voxel& voxels) {
    const auto product = static_cast<double>(voxels[0]) * voxels[1] * voxels[2];
    const std::size_t count = values.numbers.size() / each;
    if (static_cast<double>(count) == product) return;
    throw Error(values.where,
                in_quotes(values.name) + " has " + std::to_string(count) +
                    " values, but the grid " + std::to_string(voxels[0]) + " x " +
                    std::to_string(voxels[1]) + " x " + std::to_string(voxels[2]) + " voxels",
                "give one value a voxel, x first, or mend \"nx\", \"ny\" and \"nz\"");
}

std::vector<float> values_of(const Parameter& parameter, Negative negative) {
    std::vector<float> values;
    values.reserve(parameter.numbers.size());
    for (const double given : parameter.numbers) {
        const double value = negative == Negative::is_zero && given < 0 ? 0 : given;
        if (!(value >= 0 && value <= kMostDensity))
            throw Error(parameter.where,
                        in_quotes(parameter.name) +
                            " has a value that is negative, no number or above 1e18: number " +
                            std::to_string(values.size() + 1) + " of " +
                            std::to_string(parameter.numbers.size()),
                        "use 0 or more, and scale by \"scale\"");
        values.push_back(static_cast<float>(value));
    }
    return values;
}

}  // namespace

const SourceLocation& place_of(const Statement& medium, std::string_view name) {
    const Parameter* given = medium.find(name);
    return given ? given->where : medium.where;
}

Affine box_of(const Statement& medium, const Matrix& to_world) {
    const Vec3d p0 = medium.point("p0", Vec3d(0));
    const Vec3d p1 = medium.point("p1", Vec3d(1));
    const Affine map(to_world);
    Affine box;
    box.origin = map.point({std::min(p0.x, p1.x), std::min(p0.y, p1.y), std::min(p0.z, p1.z)});
    box.x = map.x * std::abs(p1.x - p0.x);
    box.y = map.y * std::abs(p1.y - p0.y);
    box.z = map.z * std::abs(p1.z - p0.z);
    if (p0.x == p1.x || p0.y == p1.y || p0.z == p1.z)
        throw Error(place_of(medium, "p1"), "\"p0\" and \"p1\" enclose no volume",
                    "make them opposite corners of the grid's box");
    if (!box.is_invertible())
        throw Error(medium.where, "the medium's box is flat, or beyond all numbers",
                    "check its matrix, \"p0\" and \"p1\"");
    return box;
}

std::optional<DensityGrid> voxels_of(const Statement& medium, std::string_view name,
                                     const Matrix& to_world, Negative negative) {
    const Parameter* values = medium.find(name, ParameterType::real);
    if (!values) return {};
    check_voxels(*values, 1, counts_of(medium));
    return field_of(medium, values_of(*values, negative), to_world);
}

std::vector<Vec3d> colours_of(const Statement& medium, std::string_view name) {
    const Parameter* given = medium.find(name, ParameterType::rgb);
    if (!given) return {};
    check_voxels(*given, 3, counts_of(medium));
    const std::vector<float> values = values_of(*given, Negative::is_refused);
    std::vector<Vec3d> colours;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        colours.emplace_back(values[i], values[i + 1], values[i + 2]);
    return colours;
}

DensityGrid field_of(const Statement& medium, const std::vector<float>& values,
                     const Matrix& to_world) {
    return density_of_parts(values, counts_of(medium), box_of(medium, to_world));
}

}  // namespace sunfleck::engine
