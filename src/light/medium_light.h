// MediumLight: the glow of a medium, as a source of photons.
//
// In:  where the medium glows, as a density on a lattice. Out: points in proportion to it, by a
// column of the lattice's cells and the depth in it; directions are uniform. The factor of an
// emission holds for light in proportion to that density: the caller corrects it by what the medium
// emits at the point. Only photons find it, and rays that cross it: it is never sampled from a
// point, since points within would see it infinitely bright.
#pragma once

#include "light/light_image.h"
#include "light/model.h"
#include "medium/density_grid.h"

#include <memory>

namespace sunfleck::engine {

struct MediumLight {
    static constexpr std::string_view name = "medium";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;  // W/(sr m^3), where the density is one
    std::uint32_t medium = 0;
    std::shared_ptr<const DensityGrid> density;
    std::shared_ptr<const LightImage> columns;  // its integrals along z of the lattice

    /// @param density  all of its lattice counts.
    MediumLight(Spectrum of, std::uint32_t medium_number, DensityGrid density);

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere&) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere&) const;
    double emission_pdf(const LightRay& ray, const SceneSphere&) const;
    std::optional<DirectSample> sample_direct(const Vec3&, const Vec2&, const SceneSphere&) const {
        return {};
    }
    double power(const SceneSphere&) const;

private:
    Ray column_at(const Vec2d& place) const;
    double volume_of_columns() const;
};

}  // namespace sunfleck::engine
