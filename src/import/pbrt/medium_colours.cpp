// Means over voxels, by how much of the medium each holds.
#include "import/pbrt/medium_colours.h"

#include "import/pbrt/medium_glow.h"
#include "import/pbrt/medium_voxels.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

using Colours = std::vector<Vec3d>;

double mean_of(const Vec3d& colour) {
    return (colour.x + colour.y + colour.z) / 3;
}

struct Voxels {
    Colours absorption;
    Colours scattering;
    Colours radiance;  // none, or one a voxel
};

/// What is not given is one (pbrt-v4), but for the radiance.
Voxels read(const Statement& medium) {
    Voxels voxels{colours_of(medium, "sigma_a"), colours_of(medium, "sigma_s"),
                  colours_of(medium, "Le")};
    if (voxels.absorption.empty() && voxels.scattering.empty())
        throw Error(medium.where,
                    "medium " + in_quotes(medium.type) + " has no \"sigma_a\" and no \"sigma_s\"",
                    "give one colour a voxel, x first");
    if (!voxels.radiance.empty() && voxels.absorption.empty())
        throw Error(place_of(medium, "Le"),
                    "medium " + in_quotes(medium.type) + " has \"Le\", but no \"sigma_a\"",
                    "only what absorbs emits: give one colour a voxel");
    const std::size_t count = std::max(voxels.absorption.size(), voxels.scattering.size());
    voxels.absorption.resize(count, Vec3d(1));
    voxels.scattering.resize(count, Vec3d(1));
    return voxels;
}

/// Returns the sum of colours over the sum of densities.
Vec3d mean_colour(const Colours& colours, double all) {
    Vec3d sum(0);
    for (const Vec3d& colour : colours) sum += colour;
    return all > 0 ? sum / all : Vec3d(0);
}

/// Returns whether each voxel has the mean colour times its density.
bool are_alike(const Colours& colours, const std::vector<float>& densities, const Vec3d& mean) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double density = densities[i];
        if ((colours[i] - mean * density).length() > 1e-3 * density) return false;
    }
    return true;
}

/// Returns what the voxels emit in one colour.
std::shared_ptr<const Glow> glow_of_colours(const Statement& medium, const Voxels& voxels,
                                            const Medium& made, const Matrix& to_world) {
    Vec3d sum(0);
    std::vector<float> emitted;
    for (std::size_t i = 0; i < voxels.radiance.size(); ++i) {
        const Vec3d here = voxels.absorption[i] * voxels.radiance[i];
        const double absorbed = mean_of(voxels.absorption[i]);
        emitted.push_back(static_cast<float>(absorbed > 0 ? mean_of(here) / absorbed : 0));
        sum += here;
    }
    const double all = mean_of(sum);
    const Vec3 colour = all > 0 ? Vec3(sum / all) : Vec3(0);
    Glow glow;
    glow.radiance = times_lescale(medium, Spectrum::rgb_illuminant(colour));
    if (!(glow.radiance.luminance() > 0)) return nullptr;
    glow.factor = std::make_shared<const Density>(field_of(medium, emitted, to_world));
    return finished_glow(std::move(glow), std::get<DensityGrid>(*made.density));
}

}  // namespace

Medium medium_of_colours(const Statement& medium, const Matrix& to_world, ImportLog& log) {
    const Voxels voxels = read(medium);
    std::vector<float> densities;
    double all = 0;
    for (std::size_t i = 0; i < voxels.absorption.size(); ++i) {
        densities.push_back(
            static_cast<float>(mean_of(voxels.absorption[i]) + mean_of(voxels.scattering[i])));
        all += double{densities.back()};
    }
    const Vec3d absorption = mean_colour(voxels.absorption, all);
    const Vec3d scattering = mean_colour(voxels.scattering, all);
    if (!are_alike(voxels.absorption, densities, absorption) ||
        !are_alike(voxels.scattering, densities, scattering))
        log.warn(medium.where, "medium " + in_quotes(medium.type) +
                                   " of a colour per voxel is not simulated: its density varies, "
                                   "its colours are their means");
    Medium made{Spectrum::rgb_unbounded(Vec3(absorption)),
                Spectrum::rgb_unbounded(Vec3(scattering)), 0,
                std::make_shared<const Density>(field_of(medium, densities, to_world))};
    if (!voxels.radiance.empty()) made.glow = glow_of_colours(medium, voxels, made, to_world);
    return made;
}

}  // namespace sunfleck::engine
