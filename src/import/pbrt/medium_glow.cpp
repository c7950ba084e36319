// Parameters and conventions of pbrt-v4's media that emit.
#include "import/pbrt/medium_glow.h"

#include "import/nvdb/density.h"
#include "import/pbrt/medium_voxels.h"
#include "import/pbrt/words.h"
#include "math/finite_product.h"
#include "medium/glow_power.h"

#include <utility>

namespace sunfleck::engine {
namespace {

std::shared_ptr<const Density> shared(DensityGrid grid) {
    return std::make_shared<const Density>(std::move(grid));
}

/// Returns temperatures, by what every grid of them knows.
Heat heat_of(const Statement& medium, DensityGrid grid) {
    const double zero = medium.real("temperatureoffset", medium.real("temperaturecutoff", 0));
    return {shared(std::move(grid)), static_cast<float>(zero),
            static_cast<float>(medium.real("temperaturescale", 1))};
}

/// "Lescale" has a value for each voxel; one value may stand for all.
void read_voxels(const Statement& medium, const Matrix& to_world, Glow& glow) {
    const Parameter* scales = medium.find("Lescale", ParameterType::real);
    if (scales != nullptr && scales->numbers.size() == 1)
        glow.radiance = times_lescale(medium, glow.radiance);
    else if (auto factor = voxels_of(medium, "Lescale", to_world, Negative::is_refused))
        glow.factor = shared(*std::move(factor));
    if (auto heat = voxels_of(medium, "temperature", to_world, Negative::is_zero))
        glow.heat = heat_of(medium, *std::move(heat));
}

/// A file may have temperatures or not.
void read_nanovdb(const Statement& medium, const Matrix& to_world, Assets& assets, Glow& glow) {
    const std::string grid = medium.text("temperaturename").value_or("temperature");
    glow.radiance = times_lescale(medium, Spectrum::constant(1));
    const SourceLocation& where = place_of(medium, "filename");
    assets.files.read_as(*medium.text("filename"), where, [&](const NamedFile& file) {
        if (has_nvdb_grid(file.bytes, grid, file.path))
            glow.heat = heat_of(medium, nvdb_density(file.bytes, grid, to_world, file.path));
    });
}

/// Returns E, without what varies, and reads that. @return nothing for media that never emit.
std::optional<Glow> read(const Statement& medium, const Matrix& to_world, Assets& assets) {
    const std::string type = *medium.text("type");
    Glow glow;
    if (type == "nanovdb") {
        read_nanovdb(medium, to_world, assets, glow);
        if (!glow.heat) return {};
        return glow;
    }
    if (type != "homogeneous" && type != "uniformgrid") return {};
    const auto given = assets.spectra.find(medium, "Le", SpectrumUse::emission);
    const bool has_heat = type == "uniformgrid" && medium.find("temperature") != nullptr;
    if (given && has_heat)
        throw Error(place_of(medium, "temperature"),
                    "medium " + in_quotes(medium.type) + " has both \"Le\" and \"temperature\"",
                    "leave one of them out");
    glow.radiance = given.value_or(Spectrum::constant(has_heat ? 1 : 0));
    if (type == "uniformgrid")
        read_voxels(medium, to_world, glow);
    else
        glow.radiance = times_lescale(medium, glow.radiance);
    return glow;
}

}  // namespace

Spectrum times_lescale(const Statement& medium, const Spectrum& radiance) {
    const double scale = medium.real("Lescale", 1);
    if (!(scale >= 0))
        throw Error(place_of(medium, "Lescale"), "\"Lescale\" is negative", "use 0 or more");
    if (auto product = finite_product(radiance, scale)) return *std::move(product);
    throw Error(medium.where,
                "medium " + in_quotes(medium.type) +
                    " is too bright: \"Le\" times \"Lescale\" is no finite float",
                "keep the product below 3.4e38");
}

std::shared_ptr<const Glow> finished_glow(Glow glow, const DensityGrid& density) {
    DensityGrid power = glow_power(density, glow);
    if (!(power.greatest() > 0)) return nullptr;
    glow.power = std::make_shared<const DensityGrid>(std::move(power));
    return std::make_shared<const Glow>(std::move(glow));
}

std::shared_ptr<const Glow> glow_of(const Statement& medium,
                                    const std::shared_ptr<const Density>& density,
                                    const Matrix& to_world, Assets& assets) {
    std::optional<Glow> glow = read(medium, to_world, assets);
    if (!glow || !(glow->radiance.luminance() > 0)) return nullptr;
    if (!glow->varies()) return std::make_shared<const Glow>(*std::move(glow));
    return finished_glow(*std::move(glow), std::get<DensityGrid>(*density));
}

}  // namespace sunfleck::engine
