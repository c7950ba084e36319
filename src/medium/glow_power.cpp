// Values at the points of a lattice, from fields that may have lattices of their own.
#include "medium/glow_power.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr float kEvenPart = 0.1F;

/// Luminance of black bodies by temperature, linear between those of a table.
class BlackBodyLuminance {
public:
    BlackBodyLuminance() {
        for (int i = 0; i <= kSteps; ++i)
            table_.push_back(
                Spectrum(BlackbodySpectrum{kStep * static_cast<float>(i)}).luminance());
    }
    float at(float kelvin) const {
        const float place = std::min(kelvin / kStep, static_cast<float>(kSteps) - 0.5F);
        if (!(place > 0)) return 0;
        const auto cell = static_cast<std::size_t>(place);
        const float part = place - static_cast<float>(cell);
        return table_[cell] * (1 - part) + table_[cell + 1] * part;
    }

private:
    static constexpr float kStep = 50;
    static constexpr int kSteps = 400;  // hotter ones hardly change their colour

    std::vector<float> table_;
};

/// Returns how many points of E stand beside each other in a cell of the density, along an axis.
int points_in_cell(const DensityGrid& density, const Glow& glow) {
    constexpr double kMost = 8;
    double ratio = 1;
    const auto look_at = [&](const std::shared_ptr<const Density>& field) {
        if (!field) return;
        const Affine& fine = std::get<DensityGrid>(*field).to_world();
        const Affine& coarse = density.to_world();
        for (const auto& [a, b] : {std::pair(coarse.x, fine.x), std::pair(coarse.y, fine.y),
                                   std::pair(coarse.z, fine.z)})
            ratio = std::max(ratio, a.length() / b.length() - 1e-3);
    };
    look_at(glow.factor);
    if (glow.heat) look_at(glow.heat->grid);
    return static_cast<int>(std::ceil(std::min(ratio, kMost)));
}

/// Luminance of E around points of a lattice.
class GlowAround {
public:
    GlowAround(const DensityGrid& density, const Glow& glow)
        : to_world_(density.to_world()),
          glow_(glow),
          points_(points_in_cell(density, glow)),
          radiance_(glow.radiance.luminance()) {}

    /// Returns the mean over even points in the cell around a point.
    float at(const Voxel& point) const {
        const auto place = [&](std::size_t axis, int i) {
            return point[axis] + (i + 0.5) / points_ - 0.5;
        };
        double sum = 0;
        for (int z = 0; z < points_; ++z)
            for (int y = 0; y < points_; ++y)
                for (int x = 0; x < points_; ++x)
                    sum += static_cast<double>(
                        light_at(Vec3(to_world_.point({place(0, x), place(1, y), place(2, z)}))));
        return static_cast<float>(sum / (points_ * points_ * points_));
    }

private:
    float light_at(const Vec3& point) const {
        const float light = radiance_ * glow_.factor_at(point);
        return glow_.heat ? light * black_body_.at(glow_.black_body_at(point).kelvin) : light;
    }

    Affine to_world_;
    const Glow& glow_;
    int points_;
    float radiance_;
    BlackBodyLuminance black_body_;
};

/// Values of a lattice that are zero where the density is.
template <class Value>
struct OnLattice {
    const DensityGrid& density;
    Value value_at;  // of a point of the lattice and the density there

    float value(const Voxel& point) const {
        const float here = density.voxels().value(point);
        return here > 0 ? value_at(point, here) : 0;
    }
    std::optional<float> constant(const Voxel& low, const Voxel&) const {
        constexpr int kCells = VoxelBlocks::kCells;
        const VoxelBlocks::Block block =
            density.voxels().block({low[0] / kCells, low[1] / kCells, low[2] / kCells});
        if (!block.values && block.constant == 0) return 0.0F;
        return {};
    }
};

template <class Value>
DensityGrid with_values(const DensityGrid& density, const Value& value_at) {
    auto voxels = std::make_shared<const VoxelBlocks>(density.voxels().cells(),
                                                      OnLattice<Value>{density, value_at});
    return DensityGrid(std::move(voxels), {}, density.to_world()).whole();
}

}  // namespace

DensityGrid glow_power(const DensityGrid& density, const Glow& glow) {
    const GlowAround around(density, glow);
    const DensityGrid light = with_values(
        density, [&](const Voxel& point, float here) { return here * around.at(point); });
    const float all = density.whole().mean();
    const float evenly = all > 0 ? kEvenPart * light.mean() / all : 0;
    const auto mixed = [&](const Voxel& point, float here) {
        return light.voxels().value(point) + evenly * here;
    };
    return with_values(density, mixed);
}

}  // namespace sunfleck::engine
