// Parameters and conventions of pbrt-v4's media.
#include "import/pbrt/medium_densities.h"

#include "import/nvdb/density.h"
#include "import/pbrt/cloud.h"
#include "import/pbrt/medium_voxels.h"
#include "import/pbrt/words.h"

#include <utility>

namespace sunfleck::engine {
namespace {

Density uniform_grid(const Statement& medium, const Matrix& to_world) {
    if (auto density = voxels_of(medium, "density", to_world, Negative::is_refused))
        return *std::move(density);
    throw Error(medium.where, "medium " + in_quotes(medium.type) + " has no \"density\"",
                "give one value a voxel, x first");
}

Density nanovdb(const Statement& medium, const Matrix& to_world, SceneFiles& files) {
    const auto name = medium.text("filename");
    if (!name || name->empty())
        throw Error(medium.where, "medium " + in_quotes(medium.type) + " has no \"filename\"",
                    "name a NanoVDB file (.nvdb)");
    const std::string grid = medium.text("gridname").value_or("density");
    return files.read_as(*name, medium.find("filename")->where, [&](const NamedFile& file) {
        return Density(nvdb_density(file.bytes, grid, to_world, file.path));
    });
}

/// The cloud's shape is told in the medium's own coordinates, whatever its box.
Density cloud(const Statement& medium, const Matrix& to_world) {
    CloudShape shape;
    const auto number = [&](std::string_view name, float fallback) {
        const double value = medium.real(name, static_cast<double>(fallback));
        if (!(value >= 0 && value <= 1e6))
            throw Error(place_of(medium, name), in_quotes(name) + " is not between 0 and 10^6",
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
                                          SceneFiles& files) {
    const std::string type = *medium.text("type");
    const auto shared = [](Density density) {
        return std::make_shared<const Density>(std::move(density));
    };
    if (type == "uniformgrid") return shared(uniform_grid(medium, to_world));
    if (type == "nanovdb") return shared(nanovdb(medium, to_world, files));
    if (type == "cloud") return shared(cloud(medium, to_world));
    return nullptr;
}

}  // namespace sunfleck::engine
