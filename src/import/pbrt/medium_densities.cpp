// Parameters and conventions of pbrt-v4's media.
#include "import/pbrt/medium_densities.h"

#include "import/nvdb/density.h"
#include "import/pbrt/cloud.h"
#include "import/pbrt/words.h"
#include "medium/density_samples.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Above, products with coefficients and distances leave floats.
constexpr double kMostDensity = 1e18;

[[noreturn]] void refuse(const SourceLocation& where, const std::string& what,
                         const std::string& mend) {
    throw Error(where, what, mend);
}

/// Returns the place of a parameter, or of the statement if it is not given.
const SourceLocation& place_of(const Statement& medium, std::string_view name) {
    const Parameter* given = medium.find(name);
    return given ? given->where : medium.where;
}

/// Returns the map of the unit cube to the box between p0 and p1, which are in any order (pbrt-v4).
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
        refuse(place_of(medium, "p1"), "\"p0\" and \"p1\" enclose no volume",
               "make them opposite corners of the grid's box");
    if (!box.is_invertible())
        refuse(medium.where, "the medium's box is flat, or beyond all numbers",
               "check its matrix, \"p0\" and \"p1\"");
    return box;
}

Voxel counts_of(const Statement& medium) {
    Voxel counts{};
    const std::array<std::string_view, 3> names = {"nx", "ny", "nz"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        counts[axis] = medium.integer(names[axis]).value_or(1);
        if (counts[axis] < 1)
            refuse(place_of(medium, names[axis]), in_quotes(names[axis]) + " is less than 1",
                   "give the number of voxels along that axis");
    }
    return counts;
}

/// @throws Error  unless there is a value for each voxel.
void check_voxels(const Parameter& values, std::size_t count, const Voxel& voxels) {
    const auto product = static_cast<double>(voxels[0]) * voxels[1] * voxels[2];
    if (static_cast<double>(count) == product) return;
    refuse(values.where,
           in_quotes(values.name) + " has " + std::to_string(count) + " values, but the grid " +
               std::to_string(voxels[0]) + " x " + std::to_string(voxels[1]) + " x " +
               std::to_string(voxels[2]) + " voxels",
           "give one value a voxel, x first, or mend \"nx\", \"ny\" and \"nz\"");
}

std::vector<float> values_of(const Parameter& density) {
    std::vector<float> values;
    values.reserve(density.numbers.size());
    for (const double value : density.numbers) {
        if (!(value >= 0 && value <= kMostDensity))
            refuse(density.where,
                   "\"density\" has a value that is negative, no number or above 1e18: number " +
                       std::to_string(values.size() + 1) + " of " +
                       std::to_string(density.numbers.size()),
                   "use 0 or more, and scale by \"scale\"");
        values.push_back(static_cast<float>(value));
    }
    return values;
}

Density uniform_grid(const Statement& medium, const Matrix& to_world, ImportLog& log) {
    const Voxel counts = counts_of(medium);
    const Parameter* density = medium.find("density", ParameterType::real);
    if (!density)
        refuse(medium.where, "medium " + in_quotes(medium.type) + " has no \"density\"",
               "give one value a voxel, x first");
    check_voxels(*density, density->numbers.size(), counts);
    if (const Parameter* heat = medium.find("temperature", ParameterType::real)) {
        check_voxels(*heat, heat->numbers.size(), counts);
        log.warn(medium.where, "medium " + in_quotes(medium.type) +
                                   " emits, which is not simulated: \"temperature\" is ignored");
    }
    return density_of_parts(values_of(*density), counts, box_of(medium, to_world));
}

Density nanovdb(const Statement& medium, const Matrix& to_world, SceneFiles& files,
                ImportLog& log) {
    const auto name = medium.text("filename");
    if (!name || name->empty())
        refuse(medium.where, "medium " + in_quotes(medium.type) + " has no \"filename\"",
               "name a NanoVDB file (.nvdb)");
    const std::string grid = medium.text("gridname").value_or("density");
    const std::string heat = medium.text("temperaturename").value_or("temperature");
    const double glow = medium.real("Lescale", 1);
    const SourceLocation& where = medium.find("filename")->where;
    return files.read_as(*name, where, [&](const NamedFile& file) {
        if (glow > 0 && has_nvdb_grid(file.bytes, heat, file.path))
            log.warn(where, "medium " + in_quotes(medium.type) +
                                " emits, which is not simulated: the grid " + in_quotes(heat) +
                                " is ignored");
        return Density(nvdb_density(file.bytes, grid, to_world, file.path));
    });
}

/// The cloud's shape is told in the medium's own coordinates, whatever its box.
Density cloud(const Statement& medium, const Matrix& to_world) {
    CloudShape shape;
    const auto number = [&](std::string_view name, float fallback) {
        const double value = medium.real(name, static_cast<double>(fallback));
        if (!(value >= 0 && value <= 1e6))
            refuse(place_of(medium, name), in_quotes(name) + " is not between 0 and 10^6",
                   "use 0 or more");
        return static_cast<float>(value);
    };
    shape.density = number("density", shape.density);
    shape.wispiness = number("wispiness", shape.wispiness);
    shape.frequency = number("frequency", shape.frequency);
    const Affine box = box_of(medium, Matrix());
    box_of(medium, to_world);
    return cloud_density(shape, box, Affine(to_world));
}

}  // namespace

std::shared_ptr<const Density> density_of(const Statement& medium, const Matrix& to_world,
                                          SceneFiles& files, ImportLog& log) {
    const std::string type = *medium.text("type");
    const auto shared = [](Density density) {
        return std::make_shared<const Density>(std::move(density));
    };
    medium.ignore({"temperatureoffset", "temperaturecutoff", "temperaturescale"});
    if (type == "uniformgrid") return shared(uniform_grid(medium, to_world, log));
    if (type == "nanovdb") return shared(nanovdb(medium, to_world, files, log));
    if (type == "cloud") return shared(cloud(medium, to_world));
    return nullptr;
}

}  // namespace sunfleck::engine
