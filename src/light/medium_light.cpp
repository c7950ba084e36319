// Columns of a lattice, and the depth in them.
#include "light/medium_light.h"

#include "math/warp.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

/// Returns the column through a point of the lattice's base. @param x, y  in cells.
Ray column_of(const DensityGrid& density, double x, double y) {
    const Affine& to_world = density.to_world();
    const double height = density.voxels().cells()[2];
    return {Vec3(to_world.point({x, y, 0})), Vec3(to_world.z.normalized()),
            static_cast<float>(height * to_world.z.length())};
}

/// Returns the integral along a column through points of the lattice, from their values: those at
/// the border of the lattice may be beyond it by rounding.
float amount_at(const DensityGrid& density, int x, int y) {
    const int height = density.voxels().cells()[2];
    double sum = 0;
    for (int z = 0; z <= height; ++z) {
        const bool is_end = z == 0 || z == height;
        sum += (is_end ? 0.5 : 1) * static_cast<double>(density.voxels().value({x, y, z}));
    }
    return static_cast<float>(sum * density.to_world().z.length());
}

/// Returns the mean integral over the columns of each cell of the base: the density is linear
/// between the columns at its corners.
std::shared_ptr<const LightImage> columns_of(const DensityGrid& density) {
    const Voxel& cells = density.voxels().cells();
    const auto size = [](int count) { return static_cast<std::size_t>(count); };
    std::vector<float> means(size(cells[0]) * size(cells[1]));
    for (int y = 0; y <= cells[1]; ++y)
        for (int x = 0; x <= cells[0]; ++x) {
            const float share = amount_at(density, x, y) / 4;
            for (const int v : {y - 1, y})
                for (const int u : {x - 1, x})
                    if (u >= 0 && v >= 0 && u < cells[0] && v < cells[1])
                        means[size(u) + size(cells[0]) * size(v)] += share;
        }
    return std::make_shared<const LightImage>(Image({cells[0], cells[1]}, 1, std::move(means)));
}

/// Returns the column of a point of the lattice, in the unit square.
Vec2d place_of(const DensityGrid& density, const Vec3d& in_lattice) {
    const Voxel& cells = density.voxels().cells();
    return {std::clamp(in_lattice.x / cells[0], 0.0, 1.0),
            std::clamp(in_lattice.y / cells[1], 0.0, 1.0)};
}

}  // namespace

MediumLight::MediumLight(Spectrum of, std::uint32_t medium_number, DensityGrid where)
    : curve(std::move(of)),
      medium(medium_number),
      density(std::make_shared<const DensityGrid>(std::move(where))),
      columns(columns_of(*density)) {}

Ray MediumLight::column_at(const Vec2d& place) const {
    const Voxel& cells = density->voxels().cells();
    return column_of(*density, place.x * cells[0], place.y * cells[1]);
}

/// Returns the volume of the lattice over the length of its columns.
double MediumLight::volume_of_columns() const {
    const Voxel& cells = density->voxels().cells();
    const Affine& to_world = density->to_world();
    return std::abs(to_world.determinant()) / to_world.z.length() * cells[0] * cells[1];
}

Emission MediumLight::sample_emission(const EmissionDimensions& u, const SceneSphere&) const {
    const auto drawn = columns->draw({u[0], u[1]});
    const Ray column = column_at(drawn.place);
    const float amount = density->amount(column);
    const float depth = density->distance_at(column, static_cast<float>(u[4]) * amount);
    const double factor = 4 * kPiDouble * double{amount} * volume_of_columns() / drawn.density;
    return {Vec3d(column.origin + column.direction * depth), uniform_sphere({u[2], u[3]}), factor,
            Vec3(0), 0};
}

EmissionDimensions MediumLight::emission_dimensions(const LightRay& ray, const SceneSphere&) const {
    const Vec3d at = density->to_grid().point(ray.origin);
    const Vec2d place = place_of(*density, at);
    const Vec2d position = columns->numbers(place);
    const Vec2d way = sphere_to_square(ray.direction);
    const Ray column = column_at(place);
    const auto depth = static_cast<float>(at.z * density->to_world().z.length());
    const double below = density->amount({column.origin, column.direction, std::max(0.0F, depth)});
    return {position.x, position.y, way.x, way.y, below / double{density->amount(column)}};
}

double MediumLight::emission_pdf(const LightRay& ray, const SceneSphere&) const {
    const Vec2d place = place_of(*density, density->to_grid().point(ray.origin));
    const double amount = density->amount(column_at(place));
    if (!(amount > 0)) return 0;
    return columns->density(place) * double{density->at(Vec3(ray.origin))} /
           (amount * volume_of_columns() * 4 * kPiDouble);
}

double MediumLight::power(const SceneSphere&) const {
    return 4 * kPiDouble * columns->mean() * volume_of_columns();
}

}  // namespace sunfleck::engine
